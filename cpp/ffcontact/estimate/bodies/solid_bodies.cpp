// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/matched_bodies.hpp"

namespace ffcontact {

FaceTractions MatchedBodies<3>::boundary_with(
    const Ref<const Matrix3Xd>& nodal) const {
  const auto& [topology, surface, system, body] = solved_;
  return with_contact(
      given_tractions<3>(topology.mesh, topology.facets, system.prescribed,
                         with_springs<3>(body.neumann, springs_)),
      topology.mesh, topology.facets, surface, nodal);
}

}  // namespace ffcontact
