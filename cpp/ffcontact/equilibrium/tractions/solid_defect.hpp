// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/tractions/equilibrium_defect.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"

namespace ffcontact {

/// How far a stress that is linear on the subtetrahedra of one tetrahedron is from
/// statically admissible, measured on its point values, as EquilibriumDefect [MPa, not
/// relative]:
///     h |div sigma + f|    in each subtetrahedron, h = the volume over the largest face
///     |jump of sigma n|    across the inner faces, and to the tractions with the given moments on the outer faces, which
///                          both tetrahedra beside a face have in common
/// at the corners.
/// @param on_faces  moments, outward
EquilibriumDefect tetrahedron_defect(const TetrahedronCorners& corners,
                                     const SolidStress& stress,
                                     const FaceLoads& on_faces,
                                     const SolidBodyLoads& body_loads);

/// Largest difference between known boundary tractions and those of the moments [MPa].
double boundary_defect(const SolidMesh& mesh, const Facets<3>& faces,
                       const FaceTractions& boundary,
                       const FaceMoments& moments);

/// Largest component of the traction on any face [MPa].
double largest_traction(const SolidMesh& mesh, const Facets<3>& faces,
                        const FaceMoments& moments);

}  // namespace ffcontact
