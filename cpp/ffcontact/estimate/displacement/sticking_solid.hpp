// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/bodies/solved_body.hpp"

namespace ffcontact {

/// As sticking_displacement of a line: where friction is rough, nodes that do not slip take
/// u_hat <- u_hat - w_t. Surfaces that do not match have no common refinement to follow each
/// other on: there only nodes that face a vertex, or a rigid foundation.
/// @param displacement  u_hat on all dofs [mm]
VectorXd sticking_displacement(const SolvedProblem<3>& solved,
                               VectorXd displacement);

}  // namespace ffcontact
