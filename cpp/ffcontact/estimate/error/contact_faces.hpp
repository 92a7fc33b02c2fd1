// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/law/surface_law.hpp"
#include "ffcontact/equilibrium/tractions/contact_facet.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"

namespace ffcontact {

/// (r_n, r_t1, r_t2) at the three vertices of each contact face, one column a face [MPa].
using SurfaceTractions = Matrix<double, 9, Dynamic>;

/// At the three vertices of one contact face, one column each.
inline Matrix3d of_face(const SurfaceTractions& tractions, Index m) {
  return tractions.col(m).reshaped(3, 3);
}

/// Motions below this part of the largest displacement have no direction.
constexpr double least_motion = 1e-9;

/// The faces of a surface whose tractions may be relaxed: those whose corners are all
/// nodes of it, against another body those that match a face of it (MatchingFace), with
/// the jump of the displacement from face to face.
/// @param displacement  u_hat on all dofs [mm]
std::vector<ContactFacet<3>> contact_faces(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const SurfaceLaw& law,
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
