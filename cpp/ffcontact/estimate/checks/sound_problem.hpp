// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/relaxation/relaxation_settings.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"

namespace ffcontact {

/// What an estimate is made of fits together, and is finite.
/// @throws std::invalid_argument  with what does not
template <int d>
void require_sound(const SolvedProblem<d>& solved,
                   const RelaxationSettings& settings);

}  // namespace ffcontact
