// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "support/loaded_solid.hpp"

/// A manufactured solid on the unit cube: u_i = sin(k_i . x), so that body forces and
/// boundary values oscillate.
namespace ffcontact::test {

struct SmoothSolid {
  double nu = 0.3;  ///< E = 1 MPa
  Matrix3d k = (Matrix3d() << 2, 1, -1, 1, 2, 1.5, -1, 1.5, 2).finished();

  double lambda() const { return nu / (1 + nu) / (1 - 2 * nu); }
  double G() const { return 0.5 / (1 + nu); }
  Vector3d displacement(const Vector3d& x) const {
    return (k * x).array().sin();
  }
  /// f = -div sigma
  Vector3d force(const Vector3d& x) const {
    const Vector3d u = displacement(x);
    return (lambda() + G()) * k.transpose() * k.diagonal().cwiseProduct(u) +
           G() * k.rowwise().squaredNorm().cwiseProduct(u);
  }
  /// Voigt
  Matrix<double, 6, 1> stress(const Vector3d& x) const {
    const Matrix3d slope = (k * x).array().cos().matrix().asDiagonal() * k,
                   strain = 0.5 * (slope + slope.transpose()),
                   s = 2 * G() * strain +
                       lambda() * strain.trace() * Matrix3d::Identity();
    Matrix<double, 6, 1> sigma;
    sigma << s(0, 0), s(1, 1), s(2, 2), s(1, 2), s(0, 2), s(0, 1);
    return sigma;
  }
};

/// Calls of_point(x, weight) at Gauss points that integrate polynomials of degree 3 over a
/// tetrahedron; the weights add up to its volume.
template <class OfPoint>
void for_gauss_points(const CellCorners<3>& corners, const OfPoint& of_point) {
  const std::array<double, 3> at{0.5 - std::sqrt(0.15), 0.5,
                                 0.5 + std::sqrt(0.15)},
      weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
  const Matrix3d B = piola_matrix(corners);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int l = 0; l < 3; ++l) {  // collapsed cube
        const double a = 1 - at[i], b = 1 - at[j];
        const Vector3d xi(at[i], a * at[j], a * b * at[l]);
        of_point(
            Vector3d(corners.col(0) + B * xi),
            B.determinant() * a * a * b * weight[i] * weight[j] * weight[l]);
      }
}

/// Exact displacements on the whole boundary, or (mixed) exact tractions on high_x and
/// high_y, linear on each face; the mean of f on each tetrahedron.
inline LoadedSolid smooth_body(const SmoothSolid& exact, const SolidMesh& mesh,
                               bool mixed) {
  LoadedSolid body(mesh, 1, exact.nu);
  const SolidField u = [&](const Vector3d& x) { return exact.displacement(x); };
  for (int t = 0; t < mesh.cell_count(); ++t) {
    Vector3d force = Vector3d::Zero();
    for_gauss_points(corners_of(mesh, t), [&](const Vector3d& x, double w) {
      force += w * exact.force(x);
    });
    body.push(t, force.replicate<1, 4>() / 4);
  }
  if (mixed)
    for (int c = 0; c < 2; ++c)
      body.load(c == 0 ? high_x : high_y, [&](const Vector3d& x) {
        return traction(exact.stress(x), Vector3d::Unit(c));
      });
  for (int side : {low_x, low_y, low_z, high_z}) body.move(side, u);
  if (!mixed)
    for (int side : {high_x, high_y}) body.move(side, u);
  return body;
}

/// |u - u_h| in energy.
inline double error_of(const SmoothSolid& exact, const LoadedSolid& body,
                       const CellStresses<3>& stress) {
  double square = 0;
  for (int t = 0; t < body.mesh().cell_count(); ++t) {
    const Matrix<double, 6, 6> compliance = body.hooke[t].inverse();
    for_gauss_points(
        corners_of(body.mesh(), t), [&](const Vector3d& x, double w) {
          const Matrix<double, 6, 1> off = exact.stress(x) - stress.col(t);
          square += w * off.dot(compliance * off);
        });
  }
  return std::sqrt(square);
}

}  // namespace ffcontact::test
