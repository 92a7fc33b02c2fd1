// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/smooth_surface_distances.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "ffcontact/interface/traction_parts.hpp"
#include "ffcontact/mesh/remeshing/smooth_surface.hpp"

namespace ffcontact {

namespace {

/// How far the smooth surface is beside a face.
class SmoothFace {
 public:
  SmoothFace(const SolidMesh& mesh, const Facets<3>& faces,
             const ContactSurface& surface, int contact_face)
      : corners_(facet_points(mesh, faces, surface.face[contact_face])),
        normals_(
            surface.normal(Eigen::all, surface.face_node.col(contact_face))),
        is_flat_(!normals_differ(surface, contact_face)) {}

  Vector3d beside(const Vector3d& place) const {
    if (is_flat_) return Vector3d::Zero();
    return point_on_cubic_triangle(corners_, normals_, place) -
           corners_ * place;
  }
  Vector3d normal_at(const Vector3d& place) const {
    return (normals_ * place).normalized();
  }

 private:
  Matrix3d corners_, normals_;
  bool is_flat_;
};

}  // namespace

void smooth_distances(const SolidMesh& mesh, const Facets<3>& faces,
                      const ContactSurface& surface,
                      const ContactSurface& opposite,
                      std::vector<FacingPolygon>& polygons) {
  std::map<int, int> place_of_face;
  for (int m = 0; m < opposite.face_count(); ++m)
    place_of_face[opposite.face[m]] = m;
  for (FacingPolygon& polygon : polygons) {
    const SmoothFace own(mesh, faces, surface, polygon.contact_face);
    const auto faced = place_of_face.find(polygon.opposite_face);
    std::optional<SmoothFace> other;
    if (faced != place_of_face.end())
      other.emplace(mesh, faces, opposite, faced->second);
    for (Index k = 0; k < polygon.distance.size(); ++k) {
      const Vector3d place = polygon.own.col(k);
      Vector3d beside = -own.beside(place);
      if (other) beside += other->beside(polygon.opposite.col(k));
      polygon.distance[k] += beside.dot(own.normal_at(place));
    }
  }
}

double largest_sagitta(const SolidMesh& mesh, const Facets<3>& faces,
                       const ContactSurface& surface) {
  double largest = 0;
  for (int m = 0; m < surface.face_count(); ++m) {
    const SmoothFace face(mesh, faces, surface, m);
    largest =
        std::max(largest, face.beside(Vector3d::Constant(1.0 / 3)).norm());
    for (int k = 0; k < 3; ++k)
      largest = std::max(
          largest,
          face.beside(0.5 * (Vector3d::Ones() - Vector3d::Unit(k))).norm());
  }
  return largest;
}

}  // namespace ffcontact
