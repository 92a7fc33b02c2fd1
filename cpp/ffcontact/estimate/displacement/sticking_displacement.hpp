// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/bodies/matched_bodies.hpp"

namespace ffcontact {

/// u_hat that sticks all along edges which friction holds. At a node that sticks in u_h
/// w_t is rounding, and between the nodes of traces that do not match it is what two
/// linear traces differ by; e would pay 2 int c |w_t| for it, c = mu |r_n|, without limit as
/// mu grows, though the solution does not depend on mu.
///
/// u_hat is any displacement that meets the supports and does not penetrate, and e of any
/// of them is a bound (2.20). Where friction is rough, c > 2 |r_n| on an edge, a node that
/// does not slip takes
///     u_hat <- u_hat - w_t t      (+ w_t t on the opposite body),
/// which leaves w_n as it is (n . t = 0) and has w_t = 0: if possible at a vertex that the common
/// refinement has cut into an edge, so that the other trace is followed exactly, whatever
/// the meshes. Its elastic energy is about |C| w_t^2 and does not depend on mu; it is done
/// where this is less than a tenth of 2 c |w_t| l, l the length of the edge, and w_t is not
/// far larger than the strain times l (slip_worth_sticking). Vertices with
/// several nodes, or with a support along t, stay.
/// @param pressure  nodal pressures F_i / len_i of the solved line [2 x p]
VectorXd sticking_displacement(const MatchedBodies<2>& bodies,
                               const Ref<const Matrix2Xd>& pressure,
                               VectorXd displacement);

/// The same on a surface, at nodes that face one vertex or a rigid foundation: surfaces that do
/// not match have no common refinement to follow each other on.
VectorXd sticking_displacement(const SolvedProblem<3>& solved,
                               VectorXd displacement);

}  // namespace ffcontact
