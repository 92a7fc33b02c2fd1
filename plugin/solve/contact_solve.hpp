// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/contact_type.hpp"
#include "solve/solve_call.hpp"

namespace ffcontact::plugin {

/// contactsolve on bodies in d dimensions, all of which this process holds; returns the
/// iterations.
template <int d>
long solve_here(const SolveCall& call, ContactOf<d>& contact);

}  // namespace ffcontact::plugin
