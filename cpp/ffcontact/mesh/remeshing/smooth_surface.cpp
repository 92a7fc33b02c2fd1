// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/smooth_surface.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace ffcontact {

namespace {

/// The nearest point of a segment, as the part of the way from a to b.
double nearest_part(const Vector3d& a, const Vector3d& b, const Vector3d& x) {
  const Vector3d along = b - a;
  return std::clamp(along.dot(x - a) / along.squaredNorm(), 0.0, 1.0);
}

/// In the plane of the side and the normal, across the normal; of the length that makes
/// Hermite's cubic a circle (SmoothCurve), chord/cos^2(theta/4), theta/2 the angle to the
/// side.
Vector3d tangent_vector(const Vector3d& side, const Vector3d& normal) {
  const Vector3d across = side - side.dot(normal) * normal;
  const double cosine = across.norm() / side.norm();
  return 2 / (cosine * (1 + cosine)) * across;
}

}  // namespace

Vector3d point_on_cubic_triangle(const Matrix3d& corners,
                                 const Matrix3d& normals,
                                 const Vector3d& place) {
  // b_iij of (3): a third of the way from corner i to j, in the tangent plane at i
  Vector3d sum = Vector3d::Zero(), of_sides = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    sum += std::pow(place[i], 3) * corners.col(i);
    for (int j = 0; j < 3; ++j) {
      if (i == j) continue;
      const Vector3d side = corners.col(j) - corners.col(i);
      const Vector3d b =
          corners.col(i) + tangent_vector(side, normals.col(i)) / 3;
      sum += 3 * place[i] * place[i] * place[j] * b;
      of_sides += b / 6;
    }
  }
  const Vector3d middle = 1.5 * of_sides - 0.5 * corners.rowwise().mean();
  return sum + 6 * place.prod() * middle;
}

Vector3d nearest_place(const Matrix3d& corners, const Vector3d& x) {
  Matrix<double, 3, 2> sides;
  sides << corners.col(1) - corners.col(0), corners.col(2) - corners.col(0);
  const Vector2d inside = (sides.transpose() * sides)
                              .ldlt()
                              .solve(sides.transpose() * (x - corners.col(0)));
  const Vector3d place(1 - inside.sum(), inside[0], inside[1]);
  if (place.minCoeff() >= 0) return place;
  Vector3d best = Vector3d::Unit(0);
  double distance = (corners.col(0) - x).norm();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double part = nearest_part(corners.col(i), corners.col(j), x);
    const Vector3d on_side =
        (1 - part) * Vector3d::Unit(i) + part * Vector3d::Unit(j);
    const double own = (corners * on_side - x).norm();
    if (own >= distance) continue;
    distance = own;
    best = on_side;
  }
  return best;
}

}  // namespace ffcontact
