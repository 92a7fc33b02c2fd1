// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/facet_oscillation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>

#include "ffcontact/equilibrium/stress/cell_geometry.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/estimate/error/line_oscillation.hpp"
#include "support/bodies.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// 1, x, y, x^2, xy, y^2 and their derivatives.
using Basis = Eigen::RowVector<double, 6>;
Basis basis(const Vector2d& p) {
  const double x = p.x(), y = p.y();
  return (Basis() << 1, x, y, x * x, x * y, y * y).finished();
}
Basis slope(const Vector2d& p, int c) {
  const double x = p.x(), y = p.y();
  if (c == 0) return (Basis() << 0, 1, 0, 2 * x, y, 0).finished();
  return (Basis() << 0, 0, 1, 0, x, 2 * y).finished();
}

/// Quadratic stresses (xx, yy, xy) on the three subtriangles of the regular triangle: 54
/// coefficients, those of subtriangle k from 18 k on.
class QuadraticStress {
 public:
  /// Rows of what is 0 or given: divergences, jumps, and tractions on the sides.
  QuadraticStress() {
    for (int k = 0; k < 3; ++k) {
      const CellCorners<2> x = subcell<2>(triangle_, k);
      for (int corner = 0; corner < 3; ++corner)
        for (int c = 0; c < 2; ++c) {
          Row row = Row::Zero();
          for (int j = 0; j < 2; ++j)
            row.segment<6>(18 * k + 6 * voigt(c, j)) += slope(x.col(corner), j);
          add(row, 0);
        }
      // along its own side, and along the inner one that it shares with the next
      const Vector2d side = x.col(1) - x.col(0), inner = x.col(2) - x.col(1);
      for (const double s : {0.0, 0.5, 1.0})
        for (int c = 0; c < 2; ++c) {
          add(traction(k, x.col(0) + s * side, normal(side), c),
              k == 0 ? 6 * s * s - 6 * s + 1 : 0, c);
          const Vector2d at = x.col(1) + s * inner;
          add(traction(k, at, normal(inner), c) -
                  traction((k + 1) % 3, at, normal(inner), c),
              0);
        }
    }
  }

  /// The largest |tau|^2 / |d|^2 of the least tau with d = q (6 s^2 - 6 s + 1) on one side.
  double largest_ratio() const {
    MatrixXd C(rows_.size(), 54), d(rows_.size(), 2);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      C.row(r) = rows_[r];
      d.row(r) = given_[r];
    }
    const MatrixXd H = energies();
    const Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver(C);
    const MatrixXd start = solver.solve(d);
    EXPECT_LT((C * start - d).norm(), 1e-12);
    const MatrixXd kernel = C.fullPivLu().kernel(),
                   left = kernel.transpose() * H * kernel;
    const MatrixXd least =
        start - kernel * left.ldlt().solve(kernel.transpose() * H * start);
    const Matrix2d energy = 5 * least.transpose() * H * least;  // |d|^2 = 1/5
    return energy.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
  }

 private:
  using Row = Eigen::RowVector<double, 54>;

  static int voigt(int i, int j) { return i == j ? i : 2; }
  static Vector2d normal(const Vector2d& side) {
    return Vector2d(side.y(), -side.x()).normalized();
  }
  static Row traction(int k, const Vector2d& at, const Vector2d& n, int c) {
    Row row = Row::Zero();
    for (int j = 0; j < 2; ++j)
      row.segment<6>(18 * k + 6 * voigt(c, j)) += n[j] * basis(at);
    return row;
  }
  void add(const Row& row, double value, int c = 0) {
    rows_.push_back(row);
    given_.push_back(value * Eigen::RowVector2d::Unit(c));
  }

  /// int tau : tau, of products of degree 4 by a rule of degree 5 on each subtriangle.
  MatrixXd energies() const {
    MatrixXd H = MatrixXd::Zero(54, 54);
    for (int k = 0; k < 3; ++k) {
      const CellCorners<2> x = subcell<2>(triangle_, k);
      const double area = volume_of<2>(x);
      for (const auto& [at, weight] : points_of_triangle()) {
        const Basis phi = basis(x * at);
        for (int v = 0; v < 3; ++v)
          H.block<6, 6>(18 * k + 6 * v, 18 * k + 6 * v) +=
              (v == 2 ? 2 : 1) * weight * area * phi.transpose() * phi;
      }
    }
    return H;
  }
  const CellCorners<2> triangle_ = regular_cell<2>();
  std::vector<Row> rows_;
  std::vector<Eigen::RowVector2d> given_;
};

TEST(FacetOscillation, constant_of_the_plane_is_that_of_quadratic_stresses) {
  const double ratio = QuadraticStress().largest_ratio();
  EXPECT_LE(ratio, traction_constant<2>);
  EXPECT_GT(ratio, traction_constant<2> - 1e-4);
}

/// A line whose directions turn, with tractions at random.
struct TurningTractions {
  Problem problem;
  ContactDensities r;

  explicit TurningTractions(Random& random)
      : problem(body(rotated(irregular(4, 2, 4, 2, random), *real(-3, 3)),
                     material(1, *real(0, 0.45)))) {
    ContactLine& line = problem.line;
    line = turned_at_random(line, 0.7, random);
    r = {random_matrix(2, line.edge_count(), random),
         random_matrix(2, line.edge_count(), random)};
  }
  double oscillation() const {
    return line_oscillation(problem.mesh, problem.edges, problem.line,
                            problem.hooke, r);
  }
};

/// v = (x'Q x)_c.
struct PlaneField {
  std::array<Matrix2d, 2> Q;
  Vector2d operator()(const Vector2d& x) const {
    return {x.dot(Q[0] * x), x.dot(Q[1] * x)};
  }
  VoigtVector<2> strain(const Vector2d& x) const {
    Matrix2d gradient;
    for (int c = 0; c < 2; ++c)
      gradient.row(c) = ((Q[c] + Q[c].transpose()) * x).transpose();
    return {gradient(0, 0), gradient(1, 1), gradient(0, 1) + gradient(1, 0)};
  }
};

/// int (r - its linear part) . v over the line, and |v|^2 on the triangles beside it.
RC_GTEST_PROP(LineOscillation, bounds_the_work_of_what_is_not_linear,
              (Random random)) {
  const TurningTractions given(random);
  const auto& [problem, r] = given;
  const ContactLine& line = problem.line;
  const PlaneField v{
      {random_matrix(2, 2, random), random_matrix(2, 2, random)}};
  double work = 0, energy = 0;
  for (int e = 0; e < line.edge_count(); ++e) {
    const Vector2d from = problem.mesh.vertices.col(
                       problem.edges.vertices(0, line.edge[e])),
                   along =
                       edge_vector(problem.mesh, problem.edges, line.edge[e]);
    const Matrix2d ends =
        density_of(contact_moments(line, r, e), line.length[e]).reshaped(2, 2);
    constexpr int steps = 400;
    for (int k = 0; k < steps; ++k) {
      const double s = (k + 0.5) / steps;
      const Vector2d d =
          traction_at(line, r, e, s) - (1 - s) * ends.col(0) - s * ends.col(1);
      work += line.length[e] / steps * d.dot(v(from + s * along));
    }
    const int t = problem.edges.cells(0, line.edge[e]);
    const CellCorners<2> x = corners_of(problem.mesh, t);
    for (int k = 0; k < 3; ++k) {
      const VoigtVector<2> strain =
          v.strain((x.col(k) + x.col((k + 1) % 3)) / 2);
      energy += volume_of<2>(x) / 3 * strain.dot(problem.hooke[t] * strain);
    }
  }
  RC_ASSERT(std::abs(work) < given.oscillation() * std::sqrt(energy));
  RC_ASSERT(std::abs(work) > 1e-9);  // there is something left
}

/// All triangles are alike.
TEST(LineOscillation, is_that_of_both_bodies) {
  const auto oscillation = [](Problem problem) {
    Random random(3);
    ContactLine& line = problem.line;
    line = turned_at_random(line, 0.7, random);
    return line_oscillation(problem.mesh, problem.edges, line, problem.hooke,
                            {random_matrix(2, line.edge_count(), random),
                             random_matrix(2, line.edge_count(), random)});
  };
  const Mesh mesh = rectangle(3, 2, 3, 2);
  const Material rubber = material(1, 0.3);
  const Bodies two = bodies({shifted(mesh, {0, 2}), mesh}, {rubber, rubber},
                            {{0, bottom, 1, top}});
  EXPECT_NEAR(oscillation(two.problem),
              std::sqrt(2.0) * oscillation(body(mesh, rubber)), 1e-15);
}

TEST(LineOscillation, is_none_where_directions_do_not_turn) {
  std::mt19937 random(3);
  const Problem problem = body(irregular(4, 2, 4, 2, random), material(1, 0.3));
  const Index edges = problem.line.edge_count();
  EXPECT_EQ(
      line_oscillation(
          problem.mesh, problem.edges, problem.line, problem.hooke,
          {random_matrix(2, edges, random), random_matrix(2, edges, random)}),
      0);
}

}  // namespace
}  // namespace ffcontact
