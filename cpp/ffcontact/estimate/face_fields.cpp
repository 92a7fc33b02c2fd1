// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/face_fields.hpp"

namespace ffcontact {

FacetFields<3> fields_on_face(const ContactSurface& surface,
                              const std::vector<FrictionCone>& cones,
                              int contact_face,
                              const Ref<const VectorXd>& traction) {
  const Vector3i nodes = surface.face_node.col(contact_face);
  const Matrix3d none = Matrix3d::Zero();
  FacetFields<3> fields{none, none, {}, {}};
  for (int k = 0; k < 3; ++k) {
    const int node = nodes[k] >= 0 ? nodes[k] : nodes.maxCoeff();
    fields.normal.col(k) = surface.normal.col(node);
    fields.traction.col(k) = surface.frame(node) * traction.segment<3>(3 * k);
    fields.cone.push_back({cones[node].bound(traction[3 * k])});
  }
  return fields;
}

}  // namespace ffcontact
