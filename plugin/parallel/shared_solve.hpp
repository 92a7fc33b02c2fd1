// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/contact_type.hpp"
#include "solve/solve_call.hpp"

namespace ffcontact::plugin {

/// contactsolve where processes share the bodies: each assembles its part of A and b, and
/// holds its part of the factor; process 0 solves the contact.
long solve_shared(const SolveCall& call, Contact& contact);

}  // namespace ffcontact::plugin
