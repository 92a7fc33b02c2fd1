// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/bodies/matched_bodies.hpp"

namespace ffcontact {

/// u_hat of bonded bodies: continuous, and 0 on a rigid foundation. Where nothing is bonded it
/// is u_h.
///
/// u_h is continuous in the mean alone, where traces do not match. On the common refinement
/// each node and the vertex that it faces take one displacement, that of their group
/// (facing_groups); all other vertices stay. Of these displacements it is the one with the
/// least potential energy: with U of the groups, P their vertices, and r what the stresses
/// of a first guess u_0 (the mean of the vertices that are none of the cuts) lack of
/// equilibrium with all loads, there without contact tractions,
///     (P'K P) (U - U_0) = P'r,
/// K of the triangles at these vertices. As e^2 / 2 is the potential energy of u_hat and the
/// complementary one of sigma_hat, no other choice of U has a lower e.
///
/// Prescribed components stay, and their groups with them. Where two that differ are in one
/// group the jump stays, too (see deepest_node).
VectorXd bonded_displacement(const MatchedBodies<2>& bodies);

/// The same of solids, whose surfaces have no common refinement: the vertices of the body that
/// follows (following_parts) take what they face. Between them w is added to it, which is
/// known by its norm alone (bonded_jump).
VectorXd bonded_displacement(const SolvedProblem<3>& solved);

}  // namespace ffcontact
