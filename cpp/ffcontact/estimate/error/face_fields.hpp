// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/error/between_nodes.hpp"
#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// Directions, tractions and bounds c of |r_t|, which e takes linear, at the corners of a
/// contact face; no motions. A corner
/// that is no node has those of one of the face's nodes.
/// @param cones     at all nodes [MPa]
/// @param traction  (r_n, r_t1, r_t2) at the corners [9]
FacetFields<3> fields_on_face(const ContactSurface& surface,
                              const std::vector<FrictionCone>& cones,
                              int contact_face,
                              const Ref<const VectorXd>& traction);

}  // namespace ffcontact
