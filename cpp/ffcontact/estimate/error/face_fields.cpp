// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/face_fields.hpp"

#include "ffcontact/interface/traction_parts.hpp"

namespace ffcontact {

FacetFields<3> fields_on_face(const ContactSurface& surface,
                              const std::vector<FrictionCone>& cones,
                              int contact_face,
                              const Ref<const VectorXd>& traction) {
  const Vector3i nodes = surface.face_node.col(contact_face);
  const FaceHats hats = face_hats(surface, contact_face);
  const Matrix3d none = Matrix3d::Zero();
  FacetFields<3> fields{none, none, {}, {}};
  fields.cone.resize(3);
  Index a = 0;  // hats of the corners that are nodes, in their order
  for (int k = 0; k < 3; ++k) {
    const int node = nodes[k] >= 0 ? nodes[k] : nodes.maxCoeff();
    fields.normal.col(k) = surface.normal.col(node);
    fields.traction.col(k) = surface.frame(node) * traction.segment<3>(3 * k);
    if (nodes[k] < 0) continue;
    const double bound = cones[node].bound(traction[3 * k]);
    for (int corner = 0; corner < 3; ++corner)
      fields.cone[corner].cohesion += hats.hat(corner, a) * bound;
    ++a;
  }
  return fields;
}

}  // namespace ffcontact
