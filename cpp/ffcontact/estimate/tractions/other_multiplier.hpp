// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"

namespace ffcontact {

/// As the end of a sentence, that the given pressures balance the stresses at a vertex if they
/// are those of the other multiplier; nothing if they do not.
/// @param without_contact  what the stresses of u_h lack beside the given loads
std::string other_multiplier_in_words(const Imbalance& imbalance,
                                      const SolvedProblem<2>& solved,
                                      const NodalResidual<2>& without_contact);

}  // namespace ffcontact
