// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/relaxation/facet_relaxation.hpp"
#include "ffcontact/estimate/tractions/first_surface_tractions.hpp"

namespace ffcontact {

/// What the estimate of a solid is made of fits together, and is finite.
/// @throws std::invalid_argument  with what does not
void require_sound(const SolvedSolidProblem& solved,
                   const RelaxationSettings& settings);

}  // namespace ffcontact
