// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/uniqueness/directed_slip.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <cstdio>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/condensed/surface_trace.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "support/bodies.hpp"
#include "support/coulomb.hpp"
#include "support/random.hpp"
#include "support/solid_bodies.hpp"

namespace ffcontact::test {
namespace {

CondensedContact relation_of(const SolidProblem& problem) {
  const ElasticSystem system = problem.system();
  const CondensedStiffness stiffness(
      system,
      surface_trace(problem.surface, problem.law, system).trace.kept_dofs);
  return surface_contact(problem.surface, problem.law, system, stiffness);
}

/// Slip along one direction of space, with weights.
DirectedSlip slip_along(const SolidProblem& problem, const Vector3d& direction,
                        double weight = 1) {
  const int nodes = problem.surface.node_count();
  DirectedSlip slip{Matrix2Xd(2, nodes), Matrix2Xd::Zero(2, nodes),
                    std::vector<char>(nodes, 0)};
  for (int i = 0; i < nodes; ++i)
    slip.weight.col(i) = weight *
                         problem.surface.frame(i).rightCols<2>().transpose() *
                         direction;
  return slip;
}

SolidProblem clamped_solid(const SolidMesh& mesh) {
  SolidProblem problem(mesh, 0.5);
  problem.move(high_z, [](const Vector3d&) { return Vector3d::Zero(); });
  return problem;
}

/// S in the components (n, x, y) = (-z, x, y) of the free vertices on the bottom, from the
/// dense stiffness.
struct DenseSurface {
  std::vector<int> nodes;  ///< of the surface, those that move
  MatrixXd nn, nt, tt;     ///< t: x, y of one node after the other

  DenseSurface(const SolidProblem& problem, const std::vector<char>& left_out) {
    const ElasticSystem system = problem.system();
    std::vector<int> n, t, inside;
    std::vector<char> taken = system.prescribed;
    for (int i = 0; i < problem.surface.node_count(); ++i) {
      const int v = problem.surface.vertex[i];
      if (!system.prescribed[3 * v + 2]) n.push_back(3 * v + 2);
      for (int c = 0; c < 2; ++c) {
        if (!left_out[i] && !system.prescribed[3 * v + c])
          t.push_back(3 * v + c), tangential.push_back(2 * i + c);
        taken[3 * v + c] = 1;
      }
      normal.push_back(count_of(n) - 1);
      taken[3 * v + 2] = 1;
    }
    for (std::size_t dof = 0; dof < taken.size(); ++dof)
      if (!taken[dof]) inside.push_back(static_cast<int>(dof));
    const MatrixXd K = problem.A;
    const auto factor = MatrixXd(K(inside, inside)).partialPivLu();
    const auto condensed = [&](const std::vector<int>& a,
                               const std::vector<int>& b) {
      return MatrixXd(K(a, b) - K(a, inside) * factor.solve(K(inside, b)));
    };
    nn = condensed(n, n);
    nt = -condensed(n, t);
    tt = condensed(t, t);
  }

  std::vector<int> normal;      ///< of each node, its place in n
  std::vector<int> tangential;  ///< of each t: 2 node + component

  MatrixXd G() const {
    return tt - nt.transpose() * nn.partialPivLu().solve(nt);
  }
  double kappa(const Matrix2Xd& weight) const {
    MatrixXd m = MatrixXd::Zero(nn.rows(), tt.rows());
    for (Index k = 0; k < m.cols(); ++k)
      m(normal[tangential[k] / 2], k) = weight.reshaped()[tangential[k]];
    return std::sqrt(Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(
                         m.transpose() * nn * m, G())
                         .eigenvalues()
                         .maxCoeff());
  }
  double dual_norm(const Matrix2Xd& moments) const {
    const VectorXd b = moments.reshaped()(tangential);
    return std::sqrt(b.dot(G().partialPivLu().solve(b)));
  }
};

RC_GTEST_PROP(DirectedSlip, constants_are_those_of_their_definitions,
              (Random random)) {
  SolidProblem problem = clamped_solid(irregular_solid(random));
  if (random() % 2) problem.guide(low_x, 0);
  if (random() % 2) problem.guide(low_y, 1);
  const int nodes = problem.surface.node_count();
  DirectedSlip slip{random_matrix(2, nodes, random),
                    random_matrix(2, nodes, random),
                    std::vector<char>(nodes, 0)};
  for (char& out : slip.left_out) out = random() % 4 == 0;
  const DirectedConstant found = directed_constant(relation_of(problem), slip);
  const DenseSurface dense(problem, slip.left_out);
  RC_ASSERT(std::abs(found.kappa / dense.kappa(slip.weight) - 1) < 1e-6);
  RC_ASSERT(std::abs(found.missed / dense.dual_norm(slip.missed) - 1) < 1e-6);
}

/// On a half space the forms of a wave along a unit vector k at the angle q to s are
///     |v|^2 = |k| G / ((1 - nu) (1 - beta^2)),   |phi|^2 = |k| G (cos^2 q / (1 - nu) + sin^2 q)
/// with beta as in the half plane: at most kappa^2 = 1 / ((1 - nu) (1 - beta^2)), and that
/// in the limit of waves across s alone.
TEST(DirectedSlip, constant_of_a_half_space) {
  SolidProblem problem = clamped_solid(brick({20, 20, 10}, {2, 2, 1}));
  DirectedSlip slip = slip_along(problem, Vector3d::UnitX());
  for (int i = 0; i < problem.surface.node_count(); ++i) {
    const Vector3d x = problem.mesh.vertices.col(problem.surface.vertex[i]);
    slip.left_out[i] =
        std::max(std::abs(x.x() - 1), std::abs(x.y() - 1)) > 0.45;
  }
  const double nu = 0.2, beta = (1 - 2 * nu) / (2 * (1 - nu)),
               most = 1 / std::sqrt((1 - nu) * (1 - beta * beta)),
               along = 1 / std::sqrt(1 - beta * beta);
  const double kappa = directed_constant(relation_of(problem), slip).kappa;
  std::printf("kappa %.4f, half plane %.4f, half space at most %.4f\n", kappa,
              along, most);
  EXPECT_GT(kappa, along);
  EXPECT_LT(kappa, most);
}

/// A plane block between two frictionless planes, one cell thick.
TEST(DirectedSlip, constant_between_two_planes_is_near_that_of_the_plane) {
  constexpr int cells = 12;
  Problem plane =
      body(rectangle(2 * cells, cells, 80, 40), material(13e3, 0.2));
  clamp(plane, top);
  const Index p = plane.line.node_count();
  const double expected =
      coulomb_constant(Condensed(plane).contact,
                       {VectorXd::Ones(p), VectorXd::Constant(p, 0.5),
                        std::vector<char>(p, 0), false},
                       0.5, StuckNodes::may_slip);
  SolidProblem solid =
      clamped_solid(brick({2 * cells, 1, cells}, {80, 40.0 / cells, 40}));
  solid.guide(low_y, 1);
  solid.guide(high_y, 1);
  const double kappa = directed_constant(relation_of(solid),
                                         slip_along(solid, Vector3d::UnitX()))
                           .kappa;
  std::printf("kappa %.4f, of the plane body %.4f\n", kappa, expected);
  EXPECT_NEAR(kappa / expected, 1, 2e-3);
}

TEST(DirectedSlip, constants_do_not_depend_on_units_and_axes) {
  std::mt19937 random(3);
  const SolidMesh mesh = irregular_solid(random);
  const Eigen::AngleAxisd turn(0.7, Vector3d(1, 2, -1).normalized());
  const Vector3d along(0.6, 0.8, 0);
  const auto constant = [&](double length, double modulus, const Matrix3d& R) {
    SolidMesh body = mesh;
    body.vertices = length * R * mesh.vertices;
    SolidProblem problem = clamped_solid(body);
    for (Index k = 0; k < problem.A.nonZeros(); ++k)
      if (problem.A.valuePtr()[k] < 1e29) problem.A.valuePtr()[k] *= modulus;
    DirectedSlip slip = slip_along(problem, R * along);
    slip.missed = length * length * modulus * slip.weight;
    return directed_constant(relation_of(problem), slip);
  };
  const DirectedConstant unit = constant(1, 1, Matrix3d::Identity());
  for (double length : {1e-6, 1.0, 1e6})
    for (double modulus : {1e-6, 1.0, 1e6}) {
      const DirectedConstant found =
          constant(length, modulus, turn.toRotationMatrix());
      EXPECT_NEAR(found.kappa / unit.kappa, 1, 1e-8);
      EXPECT_NEAR(
          found.missed / unit.missed / std::sqrt(modulus * std::pow(length, 3)),
          1, 1e-8);
    }
}

TEST(DirectedSlip, constant_is_infinite_where_no_displacement_follows) {
  const SolidMesh mesh = brick({3, 2, 2}, {3, 2, 2});
  const auto kappa = [](const SolidProblem& problem, DirectedSlip slip) {
    return directed_constant(relation_of(problem), slip).kappa;
  };
  const auto along_x = [](const SolidProblem& problem) {
    return slip_along(problem, Vector3d::UnitX());
  };
  SolidProblem held = clamped_solid(mesh);
  EXPECT_TRUE(std::isfinite(kappa(held, along_x(held))));
  held.prescribe(held.surface.vertex[4], 2, 0);
  EXPECT_TRUE(std::isinf(kappa(held, along_x(held))));
  DirectedSlip slip = along_x(held);
  slip.weight.col(4).setZero();
  EXPECT_TRUE(std::isfinite(kappa(held, slip)));

  SolidProblem edge(mesh, 0.5, {low_z, low_x});
  edge.move(high_z, [](const Vector3d&) { return Vector3d::Zero(); });
  EXPECT_TRUE(std::isinf(kappa(edge, slip_along(edge, Vector3d::UnitY()))));

  const SolidProblem loose(mesh, 0.5);
  EXPECT_TRUE(std::isfinite(kappa(loose, along_x(loose))));
  slip = along_x(loose);
  slip.weight.col(0) *= -1;
  EXPECT_TRUE(std::isinf(kappa(loose, slip)));
}

/// On a body of the same mesh that is 1e6 times stiffer.
TEST(DirectedSlip, constant_on_a_stiff_body_is_that_on_a_foundation) {
  std::mt19937 random(5);
  const SolidMesh upper = moved(brick({3, 2, 2}, {3, 2, 2}), 1, 0.15, random);
  SolidMesh lower = brick({3, 2, 1}, {3, 2, 1});
  for (int v : vertices_on(lower, high_z))
    lower.vertices.col(v) = upper.vertices.col(v % 12) + Vector3d(0, 0, 1);
  lower.vertices.row(2).array() -= 1;
  SolidStack stack({upper, lower}, 0.5);
  SolidProblem& two = stack.problem;
  const int first = 3 * stack.joined.first_vertex[1];
  for (int row = first; row < two.A.rows(); ++row)
    for (RowMatrix::InnerIterator entry(two.A, row); entry; ++entry)
      entry.valueRef() *= 1e6;
  for (int side : {stack.label(0, high_z), stack.label(1, low_z)})
    two.move(side, [](const Vector3d&) { return Vector3d::Zero(); });
  const Vector3d along(0.6, 0.8, 0);
  const SolidProblem one = clamped_solid(upper);
  const DirectedConstant on_body =
      directed_constant(relation_of(two), slip_along(two, along));
  const DirectedConstant on_foundation =
      directed_constant(relation_of(one), slip_along(one, along));
  EXPECT_NEAR(on_body.kappa / on_foundation.kappa, 1, 1e-4);
}

TEST(DirectedSlip, bound_pays_for_what_is_missed) {
  // (1 - mu kappa) B^2 = e^2 + 2 missed B
  const double B = coulomb_bound(3, 0.5, 1.5, 0.7);
  EXPECT_NEAR(0.25 * B * B, 9 + 1.4 * B, 1e-12 * B * B);
  EXPECT_NEAR(coulomb_bound(3, 0.5, 0, 0.7), 0.7 + std::hypot(3, 0.7), 1e-14);
  EXPECT_EQ(coulomb_bound(3, 0, 1.5, 0.7), 3);
  EXPECT_TRUE(std::isinf(coulomb_bound(3, 0.5, 2, 0.7)));
  EXPECT_TRUE(std::isinf(coulomb_bound(3, 0.5, 3, 0.7)));
}

}  // namespace
}  // namespace ffcontact::test
