// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/bodies/estimate_settings.hpp"
#include "ffcontact/estimate/bodies/matched_bodies.hpp"

namespace ffcontact {

/// What an estimate is made of fits together, and is finite.
/// @throws std::invalid_argument  with what does not
void require_sound(const SolvedProblem& solved,
                   const EstimateSettings& settings);

}  // namespace ffcontact
