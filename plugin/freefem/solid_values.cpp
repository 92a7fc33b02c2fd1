// SPDX-License-Identifier: GPL-3.0-or-later
#include "freefem/solid_values.hpp"

#include <map>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
//
#include "freefem/body_values.hpp"

namespace ffcontact::plugin {

std::vector<FacePlace> places_of_nodes(const ContactSurface& surface) {
  std::vector<FacePlace> places(surface.node_count());
  for (int m = surface.face_count() - 1; m >= 0; --m)
    for (int k = 0; k < 3; ++k)
      if (const int node = surface.face_node(k, m); node >= 0)
        places[node] = {surface.face[m], Vector3d::Unit(k)};
  return places;
}

std::vector<FacePlace> places_faced(
    const ContactSurface& part, const ContactSurface& whole,
    const std::vector<FacingPolygon>& polygons) {
  std::map<int, int> number;  // of each face in the part
  for (int m = 0; m < part.face_count(); ++m) number[part.face[m]] = m;
  std::vector<FacePlace> places(part.node_count());
  VectorXd nearness = VectorXd::Constant(part.node_count(), -1);
  for (const FacingPolygon& polygon : polygons) {
    const auto m = number.find(whole.face[polygon.contact_face]);
    if (m == number.end()) continue;
    for (int k = 0; k < 3; ++k) {
      const int node = part.face_node(k, m->second);
      Index corner;
      const double nearest = polygon.own.row(k).maxCoeff(&corner);
      if (node < 0 || nearest <= nearness[node]) continue;
      nearness[node] = nearest;
      places[node] = {polygon.opposite_face, polygon.opposite.col(corner)};
    }
  }
  return places;
}

VectorXd at_places(Stack stack, Expression expression, const BodyPart<3>& part,
                   const std::vector<FacePlace>& places, double otherwise) {
  if (!expression) return VectorXd::Constant(count_of(places), otherwise);
  std::vector<BoundaryPlace<3>> at;
  for (const auto& [face, coordinates] : places)
    at.push_back(on_boundary(part, face, coordinates));
  return at_boundary(stack, expression, part, at);
}

}  // namespace ffcontact::plugin
