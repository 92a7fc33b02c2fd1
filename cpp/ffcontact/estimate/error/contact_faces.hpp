// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/equilibrium/tractions/contact_facet.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"

namespace ffcontact {

/// Motions below this part of the largest displacement have no direction.
constexpr double least_motion = 1e-9;

/// The faces of a surface whose tractions may be relaxed: those whose corners are all
/// nodes of it, against another body those that match a face of it (MatchingFace), with
/// the jump of the displacement from face to face.
/// @param displacement  u_hat on all dofs [mm]
std::vector<ContactFacet<3>> contact_faces(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const ContactLaw<3>& law,
    const Ref<const VectorXd>& displacement);

/// Their places on the surface.
VectorXi surface_faces(const std::vector<ContactFacet<3>>& contact);

/// Tractions of given moments on all faces of the mesh, in the cone where they are but for
/// rounding, one column a contact face.
SurfaceTractions tractions_of(const std::vector<ContactFacet<3>>& contact,
                              const FaceMoments& moments);

/// Moments of given tractions take the place of those on the contact faces; faces that
/// match them feel the opposite change.
void put_moments(const std::vector<ContactFacet<3>>& contact,
                 const SurfaceTractions& tractions, FaceMoments& moments);

}  // namespace ffcontact
