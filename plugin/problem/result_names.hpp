// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "freefem/arguments.hpp"

/// Results that only plane bodies have, or only solids, or none.
namespace ffcontact::plugin {

/// @throws std::invalid_argument  if an output is asked for that bodies of this dimension have
///                                not
void require_results_of(int dimension, const NamedArguments& named);

/// Says what bodies of this dimension have in place of a result of others.
[[noreturn]] void refuse_result_of_others(int dimension);

/// Says that a contact is not solved.
[[noreturn]] void refuse_unsolved();

}  // namespace ffcontact::plugin
