// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"

namespace ffcontact {

/// Why the stresses of u_h are not in equilibrium with the loads at a vertex, as the end
/// of a sentence: a point support, displacements
/// prescribed along the contact line, pressures of the other multiplier, or loads that are
/// not those of u_h.
std::string cause_of(const Imbalance& imbalance, const Mesh& mesh,
                     const ContactLine& line, const ElasticSystem& system,
                     const SolvedBody& body);

}  // namespace ffcontact
