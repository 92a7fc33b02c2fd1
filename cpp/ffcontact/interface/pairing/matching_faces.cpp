// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/matching_faces.hpp"

#include <algorithm>

namespace ffcontact {

namespace {

/// Corners that are off by less than this part of the triangle's height are not.
constexpr double off_by_rounding = 1e-11;
/// Corners this near to each other, in barycentric coordinates, may match.
constexpr double same_corner = 1e-9;

/// How many polygons each face of the mesh has a part in.
std::vector<int> polygon_counts(const Facets<3>& faces,
                                const ContactSurface& surface) {
  std::vector<int> counts(faces.count(), 0);
  for (const FacingPolygon& polygon : surface.polygons) {
    ++counts[surface.face[polygon.contact_face]];
    ++counts[polygon.opposite_face];
  }
  return counts;
}

/// Is one of two triangles the other one, moved? Corner by corner.
bool is_moved(const Matrix3d& from, const Matrix3d& to) {
  const Matrix3d shift = to - from,
                 off = shift.colwise() - shift.rowwise().mean().eval();
  double longest = 0;
  for (int k = 0; k < 3; ++k)
    longest = std::max(longest, (from.col(k) - from.col((k + 1) % 3)).norm());
  const double height = 2 * facet_vector(from).norm() / longest;
  return off.colwise().norm().maxCoeff() <= off_by_rounding * height;
}

MatchingFace match_of(const SolidMesh& mesh, const Facets<3>& faces, int face,
                      const FacingPolygon& polygon) {
  MatchingFace match;
  for (int k = 0; k < 3; ++k) {
    const double share =
        polygon.own_of_opposite.row(k).maxCoeff(&match.corner[k]);
    if (share < 1 - same_corner) return {};
  }
  const Vector3i own = faces.vertices.col(face),
                 opposite = faces.vertices.col(polygon.opposite_face);
  const Matrix3d from = mesh.vertices(Eigen::all, own),
                 to = mesh.vertices(Eigen::all, opposite(match.corner));
  if (!is_moved(from, to)) return {};
  match.face = polygon.opposite_face;
  return match;
}

}  // namespace

std::vector<MatchingFace> matching_faces(const SolidMesh& mesh,
                                         const Facets<3>& faces,
                                         const ContactSurface& surface) {
  const std::vector<int> counts = polygon_counts(faces, surface);
  std::vector<MatchingFace> matches(surface.face_count());
  for (const FacingPolygon& polygon : surface.polygons) {
    const int m = polygon.contact_face, face = surface.face[m];
    const bool alone = counts[face] == 1 && counts[polygon.opposite_face] == 1;
    if (alone && surface.face_node.col(m).minCoeff() >= 0)
      matches[m] = match_of(mesh, faces, face, polygon);
  }
  return matches;
}

}  // namespace ffcontact
