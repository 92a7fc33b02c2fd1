// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/active_set/active_set.hpp"

namespace ffcontact {

/// A fixed point of Phi_h and the way there.
struct FixedPointResult {
  /// iterations: linear systems in all; violation: of Coulomb's law
  ActiveSetResult answer;
  /// largest change |Phi_h(g) - g| of a step, relative to the largest normal multiplier
  std::vector<double> history;
};

/// Coulomb's law as a fixed point of Phi_h: g -> lambda_n, where (u, lambda) solves
/// Tresca's problem P(g) with the slip limit -mu g_n [CHH01, Definition 3.1]:
///     g_0 = 0 (no friction),   g_k+1 = g_k + theta (Phi_h(g_k) - g_k).
/// theta is 1 and halved, down to 1/32, whenever a step has changed more than the one
/// before. Each P(g) is convex and solved by solve_convex from the state of the last.
/// Where mu is small Phi_h contracts and theta stays 1; where it does not, the best
/// iterate comes back with its status. For Tresca's law one step is the answer.
/// @param settings  max_iterations bounds the linear systems of all steps, which end when
///                  the violation of Coulomb's law is below
///                  the tolerance
/// @param with_newton  whenever a step has changed the states, active_set_newton tries to
///                     end from them
FixedPointResult fixed_point(const CondensedContact& contact,
                             const NodalLaw& law, ContactStates state,
                             const NewtonSettings& settings = {},
                             bool with_newton = false);

}  // namespace ffcontact
