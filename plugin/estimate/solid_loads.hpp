// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimate/oscillation.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "freefem/arguments.hpp"
#include "problem/solid_bodies.hpp"

namespace ffcontact::plugin {

/// Reads elastic law (lambda= and G=, or hooke=), initial strains and stresses
/// (initialstrain=, initialstress=), loads (traction=, bodyforce=) and springs (spring=,
/// rest=) of all solids into what is judged, by the quadratures that FreeFEM's int2d and int3d use by default, so that they
/// are the loads of the script.
/// @throws std::invalid_argument  if a solid has not one elastic law
Oscillation read_material_and_loads(Stack stack, const NamedArguments& named,
                                    const SolidBodies& bodies,
                                    SolvedBody<3>& body);

}  // namespace ffcontact::plugin
