// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/flags.hpp"
#include "ffcontact/estimate/bodies/matched_bodies.hpp"

namespace ffcontact {

/// Tractions at the nodes of a surface, and which nodes carry any.
struct CarryingNodes {
  Matrix3Xd traction;  ///< [MPa, 3 x p]
  Flags carries;       ///< [p]
};

/// Tractions off the faces that open far, as off the edges of a line (carrying_edges). A
/// traction r_i at a node costs on each face of area A
///     2 A / 3 |r_n| o,   o = (2 o_i + o_j + o_k) / 4,   o_k = gap - w_n at its vertices,
/// and where o > 3 (l / |C| + c_n) |r_max|, l^2 = A_i, c_n of a layer, no gain pays for it.
/// Such a node hands its force A_i r_i to the loaded nodes of its faces that open less, in
/// equal parts, which keep to their cones. Where there are none, as in a contact of one
/// node's width, it keeps it. Tresca's friction, which acts on open faces, too, stays.
/// @param u_hat     of the bodies, on all dofs [mm]
/// @param traction  r_hat at the nodes, in the cones
CarryingNodes carrying_nodes(const MatchedBodies<3>& bodies,
                             const Ref<const VectorXd>& u_hat,
                             const Ref<const Matrix3Xd>& traction);

}  // namespace ffcontact
