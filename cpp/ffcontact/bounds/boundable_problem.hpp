// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/admissible_pair.hpp"

namespace ffcontact {

/// @param first        the estimate of what was solved
/// @param for_coulomb  are bounds with Coulomb's law asked for, as they are for plane bodies?
/// @throws std::invalid_argument  where quantities have no strict bounds (theory_of_bounds.md),
///                                or their construction does not cover the problem yet
template <int d>
void require_boundable(const SolvedProblem<d>& solved, const Estimate<d>& first,
                       bool for_coulomb);

/// Does the friction bound depend on the pressure?
template <int d>
bool is_coulombs(const ContactLaw<d>& law);

}  // namespace ffcontact
