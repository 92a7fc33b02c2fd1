// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "freefem/arguments.hpp"

/// Results that only plane bodies have, or only solids, or none.
namespace ffcontact::plugin {

/// @throws std::invalid_argument  if an output is asked for that only solids have
void require_plane_results(const NamedArguments& named);

/// @throws std::invalid_argument  if an output is asked for that only plane bodies have
void require_solid_results(const NamedArguments& named);

/// Says what plane bodies have in place of a result of solids, and the reverse.
[[noreturn]] void refuse_result_of_solids();
[[noreturn]] void refuse_result_of_plane_bodies();

/// Says that a contact is not solved.
[[noreturn]] void refuse_unsolved();

}  // namespace ffcontact::plugin
