// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/active_set.hpp"

namespace ffcontact {

/// Coulomb's law approached from weaker friction: active_set_newton for mu/K, 2 mu/K, ..., mu, each from the states of the last
/// one that converged. With strong friction this follows a branch of solutions where Newton from stick alone cycles.
/// Tresca's bounds are left as they are.
/// @param steps  K >= 1
/// @return the answer for mu; iterations: linear systems in all
ActiveSetResult friction_continuation(const CondensedContact& contact, const NodalLaw& law,
                                      std::vector<ContactState> state, int steps, const NewtonSettings& settings = {});

}  // namespace ffcontact
