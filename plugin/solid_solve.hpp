// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solid_contact.hpp"
#include "solve_call.hpp"

namespace ffcontact::plugin {

/// contactsolve on a solid; returns the iterations.
long solve_solid(const SolveCall& call, SolidContact& contact);

/// Results at the nodes, and node= of them.
void put(const SolveCall& call, const std::vector<long>& own_vertex,
         const SolidResults& nodes);

}  // namespace ffcontact::plugin
