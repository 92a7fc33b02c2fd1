// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"

namespace ffcontact {

/// Why the stresses of u_h are not in equilibrium with the loads at a vertex, as the end
/// of a sentence: a reaction, pressures of the other multiplier, or loads that are not
/// those of u_h.
/// @param without_contact  what the stresses lack beside the given loads
template <int d>
std::string cause_of(const Imbalance& imbalance, const SolvedProblem<d>& solved,
                     const NodalResidual<d>& without_contact);

}  // namespace ffcontact
