// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/natural_map.hpp"

namespace ffcontact {

/// The next P and v of all rows 3 i + c by the equations of their nodes' states
/// (surface_newton). Unknown are v of the primary rows without the condition v = 0 and P
/// of the dependent rows that are not held. These have a proximal term r (P - last P): at
/// nodes of one vertex forces may be shared in more than one way, and stay as they are.
/// @param held  of surface_trace [3 p]
/// @param rows    the last ones, then the next; unchanged if the system is not finite
/// @param solver  of the steps before
SystemKind solve_surface_step(const CondensedContact& contact,
                              const std::vector<char>& held,
                              const NaturalMap& map,
                              const std::vector<NodeState>& states,
                              ContactRows& rows, RefinedSolver& solver);

}  // namespace ffcontact
