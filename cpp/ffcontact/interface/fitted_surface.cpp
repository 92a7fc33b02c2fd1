// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/fitted_surface.hpp"

namespace ffcontact {

namespace {

/// Normals that turn by less along a side of a face are those of a plane.
constexpr double least_turn = 0.01;

/// Sums over opposite faces of m by area at each node [3 x p], zero where nothing faces
/// it.
Matrix3Xd opposite_normals(const SolidMesh& mesh, const Facets<3>& faces,
                           const ContactSurface& surface,
                           const std::vector<FacingPolygon>& polygons) {
  Matrix3Xd sums = Matrix3Xd::Zero(3, surface.node_count());
  for (const FacingPolygon& polygon : polygons)
    for (int node : surface.face_node.col(polygon.contact_face))
      if (node >= 0)
        sums.col(node) +=
            polygon.area * facet_normal(mesh, faces, polygon.opposite_face);
  return sums;
}

/// How normals turn along the sides of contact faces.
struct Turning {
  double own = 0, common = 0;  ///< sums of a . a and a . b
  double most = least_turn;
  std::optional<NodeOfFace> node;  ///< where |a| is the largest

  void add(const NodeOfFace& at, const Vector3d& a, const Vector3d& b) {
    if (a.norm() <= least_turn) return;
    own += a.squaredNorm();
    common += a.dot(b);
    if (a.norm() <= most) return;
    most = a.norm();
    node = at;
  }
};

}  // namespace

std::optional<NodeOfFace> node_of_fitted_surface(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const std::vector<FacingPolygon>& polygons) {
  const Matrix3Xd sums = opposite_normals(mesh, faces, surface, polygons);
  Turning turning;
  for (int m = 0; m < surface.face_count(); ++m)
    for (int side = 0; side < 3; ++side) {
      const int j = surface.face_node(side, m),
                k = surface.face_node((side + 1) % 3, m);
      if (j < 0 || k < 0) continue;
      const Vector3d a = surface.normal.col(j) - surface.normal.col(k);
      if (polygons.empty())
        turning.add({j, m}, a, a);
      else if (!sums.col(j).isZero(0) && !sums.col(k).isZero(0))
        turning.add({j, m}, a,
                    sums.col(k).normalized() - sums.col(j).normalized());
    }
  const bool fits =
      turning.common > 0.5 * turning.own && turning.common < 2 * turning.own;
  return fits ? turning.node : std::nullopt;
}

}  // namespace ffcontact
