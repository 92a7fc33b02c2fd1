// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "support/free_displacement.hpp"
#include "support/problems.hpp"

/// Manufactured problems on (0, 2) x (0, 2): u = grad phi with a harmonic potential phi,
/// hence div u = 0, sigma = 2 G eps and div sigma = 0. Both are exact solutions of
/// frictionless contact on y = 0: u_n = 0, sigma_n < 0, sigma_t = 0.
namespace ffcontact::test {

struct Manufactured {
  Material material;
  Field displacement;
  std::function<Vector3d(const Vector2d&)>
      strain;  ///< Voigt, engineering shear

  Vector3d stress(const Vector2d& x) const {
    return material.hooke() * strain(x);
  }
};

/// phi = e^x cos y
inline Manufactured smooth_solution(double nu) {
  return {material(1, nu),
          [](const Vector2d& x) -> Vector2d {
            return std::exp(x.x()) *
                   Vector2d(std::cos(x.y()), -std::sin(x.y()));
          },
          [](const Vector2d& x) -> Vector3d {
            return std::exp(x.x()) * Vector3d(std::cos(x.y()), -std::cos(x.y()),
                                              -2 * std::sin(x.y()));
          }};
}

/// phi = (x + 1)^3 - 3 (x + 1) y^2: stresses and tractions are linear, as the data of the
/// discrete problem.
inline Manufactured cubic_solution(double nu) {
  return {material(1, nu),
          [](const Vector2d& x) {
            const double s = x.x() + 1, y = x.y();
            return Vector2d(3 * (s * s - y * y), -6 * s * y);
          },
          [](const Vector2d& x) {
            const double s = x.x() + 1, y = x.y();
            return Vector3d(6 * s, -6 * s, -12 * y);
          }};
}

/// Exact displacements on the whole boundary, no contact.
inline Problem without_contact(const Manufactured& exact, const Mesh& mesh) {
  Problem problem = body(mesh, exact.material);
  for (int label : {bottom, right, top, left})
    clamp(problem, label, exact.displacement);
  problem.line = ContactLine{};
  problem.law = ContactLaw<2>{};
  return problem;
}

inline VectorXd solved_without_contact(const Problem& problem) {
  return displacement(problem.system());
}

/// Frictionless contact at the bottom, exact displacements on the other sides.
inline Problem with_contact(const Manufactured& exact, const Mesh& mesh) {
  Problem problem = body(mesh, exact.material);
  for (int label : {right, top, left})
    clamp(problem, label, exact.displacement);
  return problem;
}

/// Frictionless contact at the bottom, exact tractions (linear ones) on the other sides.
inline Problem loaded_in_contact(const Manufactured& exact, const Mesh& mesh) {
  Problem problem = body(mesh, exact.material);
  for (Index b = 0; b < mesh.boundary.cols(); ++b) {
    const std::map<int, Vector2d> normals{
        {right, {1, 0}}, {top, {0, 1}}, {left, {-1, 0}}};
    const auto normal = normals.find(mesh.boundary_label[b]);
    if (normal == normals.end()) continue;
    const Vector2d a = mesh.vertices.col(mesh.boundary(0, b)),
                   c = mesh.vertices.col(mesh.boundary(1, b));
    Matrix2d density;
    density << traction(exact.stress(a), normal->second),
        traction(exact.stress(c), normal->second);
    problem.neumann.col(b) =
        facet_moments_of<2>(density, (c - a).norm()).reshaped();
    for (int end = 0; end < 2; ++end)
      problem.b.segment<2>(2 * mesh.boundary(end, b)) +=
          problem.neumann.block<2, 1>(2 * end, b);
  }
  return problem;
}

/// Points of a triangle with equal weights that integrate quadratic functions exactly on
/// its 16 parts: the middles of their sides.
inline std::vector<Vector2d> sample_points(
    const Matrix<double, 2, 3>& corners) {
  constexpr int n = 4;
  const Vector2d a = (corners.col(1) - corners.col(0)) / n,
                 b = (corners.col(2) - corners.col(0)) / n;
  std::vector<Vector2d> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n - i; ++j) {
      const auto add = [&](double x, double y) {
        points.push_back(corners.col(0) + (i + x) * a + (j + y) * b);
      };
      add(0.5, 0), add(0, 0.5), add(0.5, 0.5);
      // the triangle turned upside down
      if (i + j < n - 1) add(0.5, 1), add(1, 0.5), add(0.5, 0.5);
    }
  return points;
}

/// |C eps(u) - sigma| in energy, for stresses by their corner values on the subtriangles.
inline double distance(const Manufactured& exact, const Mesh& mesh,
                       const std::vector<SubcellStress<2>>& sigma) {
  const Matrix3d compliance = exact.material.hooke().inverse();
  double square = 0;
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      Matrix<double, 2, 3> corners;
      corners << mesh.corner(t, (k + 1) % 3), mesh.corner(t, (k + 2) % 3),
          (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
      Matrix3d of_corners;  // (1, x, y)
      of_corners << Eigen::RowVector3d::Ones(), corners;
      const Matrix3d linear =
          sigma[t].middleCols<3>(3 * k) * of_corners.inverse();
      const std::vector<Vector2d> points = sample_points(corners);
      for (const Vector2d& x : points) {
        const Vector3d difference =
            exact.stress(x) - linear * Vector3d(1, x.x(), x.y());
        square += signed_area(mesh, t) / (3.0 * points.size()) *
                  difference.dot(compliance * difference);
      }
    }
  return std::sqrt(square);
}

/// |u - u_h| in energy.
inline double error_of(const Manufactured& exact, const Problem& problem,
                       const VectorXd& displacement) {
  const Matrix3Xd sigma = stresses(problem.mesh, problem.hooke, displacement);
  std::vector<SubcellStress<2>> values;
  for (Index t = 0; t < sigma.cols(); ++t)
    values.push_back(sigma.col(t).replicate<1, 9>());
  return distance(exact, problem.mesh, values);
}

}  // namespace ffcontact::test
