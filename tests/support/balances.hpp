// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>

#include "ffcontact/equilibrium/stress/composite_stress.hpp"
#include "ffcontact/mesh/mesh.hpp"
#include "support/random.hpp"

/// Equilibrium of one triangle in force and moment, and random elastic laws.
namespace ffcontact::test {

/// An elastic law, or the inverse of one: symmetric and positive definite, coupling all
/// components.
inline Matrix3d random_law(Random& random) {
  const Matrix3d A = random_matrix(3, 3, random);
  return A * A.transpose() + 0.2 * Matrix3d::Identity();
}

inline double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

inline Vector2d centroid(const TriangleCorners& corners) {
  return corners.rowwise().mean();
}

/// Rows: force along x and y and moment about the centroid of the twelve edge loads and
/// the six body loads. All act at the vertices, since x = sum of x_i phi_i.
inline Matrix<double, 3, 18> balance_conditions(
    const TriangleCorners& corners) {
  Matrix<double, 3, 18> conditions;
  for (int force = 0; force < 9; ++force) {
    const int vertex = force < 6 ? (force / 2 + 1 + force % 2) % 3 : force - 6;
    const Vector2d arm = corners.col(vertex) - centroid(corners);
    conditions.middleCols<2>(2 * force) << 1, 0, 0, 1, -arm.y(), arm.x();
  }
  return conditions;
}

/// Force and moment (divided by the size of the triangle) of all loads.
inline Vector3d out_of_balance(const TriangleCorners& corners,
                               const EdgeLoads& on_edges,
                               const BodyLoads& in_body) {
  Matrix<double, 18, 1> loads;
  loads << on_edges, in_body;
  Vector3d result = balance_conditions(corners) * loads;
  result[2] /= (corners.col(1) - corners.col(0)).norm();
  return result;
}

struct Loads {
  EdgeLoads on_edges;
  BodyLoads in_body;
};

/// Random loads of about 1 N/mm in equilibrium.
inline Loads balanced_loads(const TriangleCorners& corners,
                            std::mt19937& random) {
  const MatrixXd kernel =
      MatrixXd(balance_conditions(corners)).fullPivLu().kernel();
  const VectorXd loads = kernel * random_vector(kernel.cols(), random);
  return {loads.head<12>(), loads.tail<6>()};
}

/// A triangle of about the size 1 with angles that are not too small.
inline TriangleCorners random_triangle(std::mt19937& random) {
  for (;;) {
    const TriangleCorners corners = random_matrix(2, 3, random);
    if (cross(corners.col(1) - corners.col(0),
              corners.col(2) - corners.col(0)) > 0.2)
      return corners;
  }
}

inline Mesh single_triangle(const TriangleCorners& corners) {
  Mesh mesh;
  mesh.vertices = corners;
  mesh.cells = (Matrix3Xi(3, 1) << 0, 1, 2).finished();
  mesh.boundary = (Matrix2Xi(2, 3) << 1, 2, 0, 2, 0, 1).finished();
  mesh.boundary_label.setConstant(3, 1);
  return mesh;
}

}  // namespace ffcontact::test
