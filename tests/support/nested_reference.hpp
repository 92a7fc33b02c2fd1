// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "support/estimates.hpp"
#include "support/random.hpp"

/// Errors against the solution on a nested finer mesh, in the energy norm.
namespace ffcontact::test {

/// Values at the vertices of the `ratio` times finer rectangle of a field on
/// rectangle(nx, ny, ...), exactly: the diagonals of the fine squares lie on those of the
/// coarse ones.
inline VectorXd on_finer_rectangle(const VectorXd& coarse, int nx, int ny,
                                   int ratio) {
  const int fine_x = nx * ratio, fine_y = ny * ratio;
  VectorXd fine(2 * (fine_x + 1) * (fine_y + 1));
  const auto value = [&](int i, int j) {
    return Vector2d(coarse.segment<2>(2 * (j * (nx + 1) + i)));
  };
  for (int j = 0; j <= fine_y; ++j)
    for (int i = 0; i <= fine_x; ++i) {
      const int I = std::min(i / ratio, nx - 1),
                J = std::min(j / ratio, ny - 1);
      const double x = static_cast<double>(i) / ratio - I,
                   y = static_cast<double>(j) / ratio - J;
      const Vector2d corner = value(I, J), opposite = value(I + 1, J + 1);
      // below or above the diagonal
      const Vector2d other = x >= y ? value(I + 1, J) : value(I, J + 1);
      fine.segment<2>(2 * (j * (fine_x + 1) + i)) =
          x >= y
              ? corner + (x - y) * (other - corner) + y * (opposite - corner)
              : corner + (y - x) * (other - corner) + x * (opposite - corner);
    }
  return fine;
}

/// Every triangle cut into four, which nests; `times` times over.
inline Mesh subdivided(Mesh mesh, int times) {
  for (; times > 0; --times) {
    std::map<std::pair<int, int>, int> middle;
    std::vector<Vector2d> vertices(mesh.vertices.colwise().begin(),
                                   mesh.vertices.colwise().end());
    const auto between = [&](int a, int b) {
      const auto [place, is_new] =
          middle.emplace(std::minmax(a, b), static_cast<int>(vertices.size()));
      if (is_new)
        vertices.push_back(0.5 * (mesh.vertices.col(a) + mesh.vertices.col(b)));
      return place->second;
    };
    Mesh fine;
    fine.cells.resize(3, 4 * mesh.cells.cols());
    for (int t = 0; t < mesh.cell_count(); ++t) {
      const Vector3i v = mesh.cells.col(t);
      const Vector3i m(between(v[1], v[2]), between(v[2], v[0]),
                       between(v[0], v[1]));
      fine.cells.middleCols<4>(4 * t) << v[0], v[1], v[2], m[0], m[2], m[0],
          m[1], m[1], m[1], m[2], m[0], m[2];
    }
    fine.boundary.resize(2, 2 * mesh.boundary.cols());
    fine.boundary_label.resize(2 * mesh.boundary.cols());
    for (Index e = 0; e < mesh.boundary.cols(); ++e) {
      const int a = mesh.boundary(0, e), b = mesh.boundary(1, e),
                m = between(a, b);
      fine.boundary.middleCols<2>(2 * e) << a, m, m, b;
      fine.boundary_label.segment<2>(2 * e).setConstant(mesh.boundary_label[e]);
    }
    fine.vertices.resize(2, static_cast<Index>(vertices.size()));
    for (std::size_t v = 0; v < vertices.size(); ++v)
      fine.vertices.col(v) = vertices[v];
    mesh = std::move(fine);
  }
  return mesh;
}

/// |v| = a(v, v)^(1/2).
inline double energy_norm(const Problem& problem, const VectorXd& v) {
  return std::sqrt(v.dot(stiffness(problem.mesh, problem.hooke) * v));
}

/// Squares of |sigma - sigma_hat| and |u - u_hat| in the energy norm.
struct SquaredDistances {
  double stress, displacement;
};

using Polygon = std::vector<Vector2d>;

inline double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The part of a convex polygon on the left of the line from a to b (Sutherland,
/// Hodgman).
inline Polygon left_part(const Polygon& polygon, const Vector2d& a,
                         const Vector2d& b) {
  Polygon part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2d &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
    if (at_p >= 0) part.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
      part.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return part;
}

inline Polygon intersection(const CellCorners<2>& a, const CellCorners<2>& b) {
  const Eigen::Array2d apart =
      (a.rowwise().minCoeff() - b.rowwise().maxCoeff())
          .cwiseMax(b.rowwise().minCoeff() - a.rowwise().maxCoeff());
  if (apart.maxCoeff() >= 0) return {};
  Polygon part{a.col(0), a.col(1), a.col(2)};
  for (int k = 0; k < 3; ++k)
    part = left_part(part, b.col(k), b.col((k + 1) % 3));
  return part;
}

/// Integral over a convex polygon of a quadratic function: three points a triangle are
/// exact.
template <class Function>
double integral(const Polygon& polygon, Function&& f) {
  double sum = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Vector2d &a = polygon[0], &b = polygon[k - 1], &c = polygon[k];
    sum += cross(b - a, c - a) / 6 *
           (f(0.5 * (a + b)) + f(0.5 * (b + c)) + f(0.5 * (c + a)));
  }
  return sum;
}

inline Vector3d barycentric(const CellCorners<2>& corners, const Vector2d& x) {
  Matrix3d system;
  system << corners, Eigen::RowVector3d::Ones();
  return system.inverse() * Vector3d(x.x(), x.y(), 1);
}

/// Distances, exactly, of an admissible pair from a reference solution whose stress is
/// constant on the fine triangles. The pair is on the bodies or on their common
/// refinement.
inline SquaredDistances squared_distances(const Problem& coarse,
                                          const Estimate<2>& estimate,
                                          const Problem& fine,
                                          const VectorXd& reference) {
  const Mesh& mesh =
      estimate.refinement ? estimate.refinement->mesh : coarse.mesh;
  Hooke hooke = coarse.hooke;
  if (estimate.refinement) {
    hooke.clear();
    for (int t : estimate.refinement->parent) hooke.push_back(coarse.hooke[t]);
  }
  const Matrix3Xd sigma = stresses(fine.mesh, fine.hooke, reference);
  const Matrix3Xd sigma_of_u_hat = stresses(mesh, hooke, estimate.displacement);
  SquaredDistances squares{0, 0};
  for (int T = 0; T < mesh.cell_count(); ++T) {
    const CellCorners<2> corners = corners_of(mesh, T);
    const Matrix3d compliance = hooke[T].inverse();
    for (int k = 0; k < 3; ++k) {
      CellCorners<2> sub;
      sub << corners.col((k + 1) % 3), corners.col((k + 2) % 3),
          corners.rowwise().mean();
      for (int t = 0; t < fine.mesh.cell_count(); ++t) {
        const Polygon part = intersection(corners_of(fine.mesh, t), sub);
        if (part.size() < 3) continue;
        const Vector3d of_fine = sigma.col(t),
                       d_u = of_fine - sigma_of_u_hat.col(T);
        squares.displacement += integral(
            part, [&](const Vector2d&) { return d_u.dot(compliance * d_u); });
        squares.stress += integral(part, [&](const Vector2d& x) {
          const Vector3d d = of_fine - estimate.stress[T].middleCols<3>(3 * k) *
                                           barycentric(sub, x);
          return d.dot(compliance * d);
        });
      }
    }
  }
  return squares;
}

/// Values at the nodes of a nested finer contact line, which is one straight line, of what
/// is linear on the edges of a coarse one.
inline VectorXd on_finer_line(const ContactLine& coarse, const VectorXd& values,
                              const ContactLine& fine) {
  VectorXd finer(fine.node_count());
  for (int i = 0; i < fine.node_count(); ++i) {
    int j = 1;
    while (j < coarse.node_count() - 1 && coarse.abscissa[j] < fine.abscissa[i])
      ++j;
    const double begin = coarse.abscissa[j - 1],
                 x = (fine.abscissa[i] - begin) / (coarse.abscissa[j] - begin);
    finer[i] = (1 - x) * values[j - 1] + x * values[j];
  }
  return finer;
}

/// sum of l_i |w_i| - int |w| of a slip that is linear on the edges [mm^2]: nothing but on
/// edges where it changes sign.
inline double excess_of_lumping(const ContactLine& line, const VectorXd& slip) {
  double sum = 0;
  for (int e = 0; e < line.edge_count(); ++e) {
    const double a = slip[line.edge_node(0, e)], b = slip[line.edge_node(1, e)];
    if (a * b < 0) sum += line.length[e] * std::abs(a * b / (a - b));
  }
  return sum;
}

/// Both sides of (2.20) without friction or with Tresca's law of a constant k, and a
/// solution for nodal forces on a nested finer mesh in place of the exact one. Its law has
/// sum of k l_i |w_i| where the exact one has int k |w_t|; from the one for u_hat and the
/// other for the solution follows
///     |sigma - sigma_hat|^2 + |u - u_hat|^2 <= e^2 + 2 k (excess of u_hat - excess of u).
struct BoundByReference {
  double errors;  ///< left
  double bound;   ///< right
};

inline BoundByReference bound_by_reference(const Problem& coarse,
                                           const Estimate<2>& estimate,
                                           const Problem& fine,
                                           const VectorXd& reference) {
  const SquaredDistances squares =
      squared_distances(coarse, estimate, fine, reference);
  const auto slip = [](const Problem& problem, const VectorXd& u) {
    return VectorXd(
        displacement_against_foundation(problem.line, problem.law, u).row(1));
  };
  double excess = 0;
  if (fine.law.tresca())
    excess = fine.law.slip_bound[0] *
             (excess_of_lumping(
                  fine.line, on_finer_line(coarse.line,
                                           slip(coarse, estimate.displacement),
                                           fine.line)) -
              excess_of_lumping(fine.line, slip(fine, reference)));
  return {squares.stress + squares.displacement,
          estimate.e * estimate.e + 2 * excess};
}

/// A block on any mesh, pressed on the foundation by its clamped top and loaded on its
/// sides.
struct RandomBlock {
  Mesh mesh;
  Vector2d on_left, on_right;
  double nu;
  Multiplier multiplier;

  /// On its mesh or a finer one, without a law.
  Problem on(const Mesh& body_mesh) const {
    Problem problem = body(body_mesh, material(1e3, nu));
    clamp(problem, top, [](const Vector2d&) { return Vector2d(1e-3, -1e-2); });
    add_traction(problem, left, on_left);
    add_traction(problem, right, on_right);
    problem.law.multiplier = multiplier;
    return problem;
  }
};

inline RandomBlock random_block(Random& random) {
  const int nx = *rc::gen::inRange(2, 6), ny = *rc::gen::inRange(2, 5);
  const Mesh mesh = irregular(nx, ny, 6, 4, random);
  const Vector2d on_left = random_vector(2, random) * 5,
                 on_right = random_vector(2, random) * 5;
  return {mesh, on_left, on_right, *real(0, 0.4),
          *rc::gen::element(Multiplier::force, Multiplier::pressure)};
}

}  // namespace ffcontact::test
