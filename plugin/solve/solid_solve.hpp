// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/solid_contact.hpp"
#include "solve/solve_call.hpp"

namespace ffcontact::plugin {

/// contactsolve on a solid; returns the iterations.
long solve_solid(const SolveCall& call, SolidContact& contact);

}  // namespace ffcontact::plugin
