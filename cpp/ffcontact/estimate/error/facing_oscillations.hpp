// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/tractions/contact_facet.hpp"
#include "ffcontact/equilibrium/tractions/facing_oscillation.hpp"
#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// What faces do not carry of the tractions of facing_faces that face them: their sum is that
/// of |d|_F'^2 (facet_oscillation.hpp), o^2 where no tetrahedron has two of them.
/// @param contact   among others faces that have a FacingPart
/// @param traction  at the nodes of all faces; that of others stays
std::vector<FacingOscillation<3>> facing_oscillations(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const HookeTensors<3>& hooke,
    const std::vector<ContactFacet<3>>& contact,
    const Ref<const Matrix3Xd>& traction);

}  // namespace ffcontact
