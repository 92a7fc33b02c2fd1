// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimate/oscillation.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "problem/plane_bodies.hpp"

namespace ffcontact::plugin {

/// Reads elastic law (lambda= and G=, or hooke=), initial strains and stresses
/// (initialstrain=, initialstress=), loads (traction=, bodyforce=) and springs (spring=,
/// rest=) of all bodies into what is judged.
/// @throws std::invalid_argument  if a body has not one elastic law, or springs at rest
///                                and none
Oscillation read_material_and_loads(Stack stack, const NamedArguments& named,
                                    const PlaneBodies& bodies,
                                    SolvedBody<2>& body);

}  // namespace ffcontact::plugin
