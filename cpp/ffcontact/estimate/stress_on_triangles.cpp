// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/stress_on_triangles.hpp"

#include <Eigen/LU>
#include <limits>
#include <map>

namespace ffcontact {

namespace {

/// The smallest of these coordinates says how far inside a point is.
Vector3d barycentric(const TriangleCorners& corners, const Vector2d& x) {
  Matrix3d system;
  system << corners, Eigen::RowVector3d::Ones();
  return system.partialPivLu().solve(Vector3d(x.x(), x.y(), 1));
}

/// The stress at a point of one of some triangles.
Vector3d stress_at(const Mesh& mesh, const std::vector<CompositeStress>& stress,
                   const std::vector<int>& triangles, const Vector2d& x) {
  int best = triangles.front();
  Vector3d place = Vector3d::Constant(-std::numeric_limits<double>::infinity());
  for (int t : triangles) {
    const Vector3d coordinates = barycentric(corners_of(mesh, t), x);
    if (coordinates.minCoeff() > place.minCoeff()) {
      best = t;
      place = coordinates;
    }
  }
  int k;  // the subtriangle opposite to the vertex that is farthest away
  place.minCoeff(&k);
  const TriangleCorners corners = corners_of(mesh, best);
  TriangleCorners sub;
  sub << corners.col((k + 1) % 3), corners.col((k + 2) % 3),
      corners.rowwise().mean();
  return stress[best].middleCols<3>(3 * k) * barycentric(sub, x);
}

}  // namespace

std::vector<CompositeStress> stress_on_triangles(const Mesh& mesh,
                                                 const Estimate& estimate) {
  if (!estimate.refinement) return estimate.stress;
  const CommonRefinement& refinement = *estimate.refinement;
  std::vector<CompositeStress> stress(
      estimate.stress.begin(), estimate.stress.begin() + mesh.cell_count());
  std::map<int, std::vector<int>> parts;
  for (int t = mesh.cell_count(); t < refinement.mesh.cell_count(); ++t) {
    std::vector<int>& of_parent = parts[refinement.parent[t]];
    if (of_parent.empty()) of_parent.push_back(refinement.parent[t]);
    of_parent.push_back(t);
  }
  for (const auto& [parent, children] : parts) {
    const TriangleCorners corners = corners_of(mesh, parent);
    const Vector2d centre = corners.rowwise().mean();
    for (int k = 0; k < 3; ++k) {
      Matrix<double, 2, 3> sub;
      sub << corners.col((k + 1) % 3), corners.col((k + 2) % 3), centre;
      const Vector2d middle = sub.rowwise().mean();
      for (int c = 0; c < 3; ++c) {
        constexpr double inwards = 1e-6;
        const Vector2d x = sub.col(c) + inwards * (middle - sub.col(c));
        stress[parent].col(3 * k + c) =
            stress_at(refinement.mesh, estimate.stress, children, x);
      }
    }
  }
  return stress;
}

}  // namespace ffcontact
