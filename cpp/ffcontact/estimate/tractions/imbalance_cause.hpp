// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/estimate/bodies/matched_bodies.hpp"

namespace ffcontact {

/// Why the stresses of u_h are not in equilibrium with the loads at a vertex, as the end
/// of a sentence: a reaction, pressures of the other multiplier, or loads that are not
/// those of u_h.
std::string cause_of(const Imbalance& imbalance,
                     const SolvedProblem<2>& solved);

}  // namespace ffcontact
