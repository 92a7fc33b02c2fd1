// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arguments.hpp"
#include "solid_contact.hpp"

namespace ffcontact::plugin {

/// contacterror(C, ...) for the contact of a mesh3 that contactsolve has solved.
/// The contact keeps what was made of it.
/// @return eps
double solid_error(Stack stack, const NamedArguments& named,
                   SolidContact& contact);

}  // namespace ffcontact::plugin
