// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "support/random.hpp"

/// Equilibrium of one tetrahedron in force and moment.
namespace ffcontact::test {

/// A tetrahedron of about the size 1 that is not flat.
inline TetrahedronCorners random_tetrahedron(std::mt19937& random) {
  for (;;) {
    const TetrahedronCorners corners = random_matrix(3, 4, random);
    if (piola_matrix(corners).determinant() > 0.4) return corners;
  }
}

inline Matrix3d cross_matrix(const Vector3d& x) {
  Matrix3d matrix;
  matrix << 0, -x.z(), x.y(), x.z(), 0, -x.x(), -x.y(), x.x(), 0;
  return matrix;
}

/// Rows: force, and moment about the barycentre, of the 36 face loads and the 12 body
/// loads. All act at the vertices, since x = sum of x_i phi_i.
inline Matrix<double, 6, 48> balance_conditions(
    const TetrahedronCorners& corners) {
  const Vector3d centre = corners.rowwise().mean();
  Matrix<double, 6, 48> conditions;
  for (int force = 0; force < 16; ++force) {
    const int vertex =
        force < 12 ? vertex_of_facet<3>(force / 3, force % 3) : force - 12;
    conditions.middleCols<3>(3 * force) << Matrix3d::Identity(),
        cross_matrix(corners.col(vertex) - centre);
  }
  return conditions;
}

/// Force, and moment over the longest edge from vertex 0 [N].
inline Matrix<double, 6, 1> out_of_balance(const TetrahedronCorners& corners,
                                           const FaceLoads& on_faces,
                                           const SolidBodyLoads& in_body) {
  Matrix<double, 48, 1> loads;
  loads << on_faces.reshaped(), in_body.reshaped();
  Matrix<double, 6, 1> result = balance_conditions(corners) * loads;
  result.tail<3>() /= piola_matrix(corners).colwise().norm().maxCoeff();
  return result;
}

struct SolidLoads {
  FaceLoads on_faces;
  SolidBodyLoads in_body;
};

/// Random loads of about 1 N in equilibrium.
inline SolidLoads balanced_solid_loads(const TetrahedronCorners& corners,
                                       std::mt19937& random) {
  const MatrixXd kernel =
      MatrixXd(balance_conditions(corners)).fullPivLu().kernel();
  const VectorXd loads = kernel * random_vector(kernel.cols(), random);
  return {loads.head<36>().reshaped(3, 12), loads.tail<12>().reshaped(3, 4)};
}

}  // namespace ffcontact::test
