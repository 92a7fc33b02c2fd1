// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/stress/composite_stress.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// Edge tractions in equilibrium with the body forces on every triangle, built star by
/// star [CHH01, 4.2.2, first step].
///
/// For vertex i and each triangle E of its star the moments b of the two edges at i
/// balance the finite element stress,
///     sum of eta b = int_E (sigma_h : eps(phi_i e) - f . phi_i e) = |E| sigma_h grad phi_i - int_E f phi_i,
/// which makes every triangle balanced in force and moment, since rigid motions are
/// combinations of phi_i e. Around the star this is a chain: one free parameter per
/// component, taken by least squares to the mean of the stresses on both sides, unless a
/// boundary edge of the star has its moment given. The last equation holds where nothing
/// is missing at i (NodalResidual).
/// @param stress      sigma_h per triangle, Voigt [MPa]
/// @param body_loads  int_E f phi_i at the three vertices of each triangle [N/mm, 6 x
///                    triangles]
EdgeMoments equilibrated_moments(const Topology& topology,
                                 const Ref<const Matrix3Xd>& stress,
                                 const BodyLoadsOfAll& body_loads,
                                 const BoundaryTractions& boundary);

}  // namespace ffcontact
