// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/tractions/solid_residual.hpp"

namespace ffcontact {

/// Face tractions in equilibrium with the body forces on every tetrahedron, built vertex
/// by vertex [CHH01, 4.2.2, first step, in space].
///
/// For vertex i and each tetrahedron T of its star the moments b of the three faces at i
/// balance the finite element stress,
///     sum of eta b = |T| sigma_h grad phi_i - int_T f phi_i,
/// which makes every tetrahedron balanced in force and moment, since rigid motions are
/// combinations of phi_i e. Per component this is a graph: tetrahedra are its nodes,
/// faces its arcs. Of the solutions the one nearest to z0 = A/3 (mean of both stresses) n
/// in the norm with weights 1/A, A the area of the face, is taken:
///     z = z0 + W N' (N W N')^+ (q - N z0),   N the incidence of the arcs not known, W = diag(A).
/// Where no free boundary face ends a star, the equations fit one another if nothing is
/// missing at i (SolidResidual); what is missing all its tetrahedra share.
/// @param stress      sigma_h per tetrahedron, Voigt [MPa]
/// @param body_loads  int_T f phi_i at the four vertices of each tetrahedron [N]
FaceMoments equilibrated_moments(const SolidTopology& topology,
                                 const Ref<const Matrix6Xd>& stress,
                                 const SolidBodyLoadsOfAll& body_loads,
                                 const FaceTractions& boundary);

}  // namespace ffcontact
