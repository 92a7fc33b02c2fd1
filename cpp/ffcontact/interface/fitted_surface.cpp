// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/fitted_surface.hpp"

namespace ffcontact {

namespace {

/// Do contact directions of a surface and the opposite normals turn together? Sums
/// over pairs of neighbouring nodes, a = n_j - n_i of the directions and b = m_i - m_j of
/// the normals: (sum a . b) / (sum a . a) is 1 for a pin in its bore, 0 on a plane,
/// negative for two balls.
class CommonTurn {
 public:
  /// Directions that turn by less between two nodes are those of a plane.
  static constexpr double least = 0.01;

  /// @return whether the directions turn there
  bool add(const Vector3d& a, const Vector3d& b) {
    if (a.norm() <= least) return false;
    own_ += a.squaredNorm();
    common_ += a.dot(b);
    return true;
  }
  /// Is the ratio between 1/2 and 2?
  bool fits() const { return common_ > 0.5 * own_ && common_ < 2 * own_; }

 private:
  double own_ = 0, common_ = 0;
};

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
  CommonTurn turn;
  double most = CommonTurn::least;
  std::optional<NodeOfFace> node;  ///< where |a| is the largest

  void add(const NodeOfFace& at, const Vector3d& a, const Vector3d& b) {
    if (!turn.add(a, b) || a.norm() <= most) return;
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
  return turning.turn.fits() ? turning.node : std::nullopt;
}

}  // namespace ffcontact
