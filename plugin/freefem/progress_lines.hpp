// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/progress.hpp"

namespace ffcontact::plugin {

/// Dofs of a body on which a phase takes about 2 s.
constexpr double many_dofs(int dim) { return dim == 2 ? 3e5 : 5e4; }

/// Prints a line of what takes long: the beginning of a phase on many dofs, and at most
/// every 2 s a step. Empty at verbosity 0.
/// @param function  of the script
/// @param dim       of the bodies
ProgressReport progress_lines(const char* function, long verbosity, int dim);

}  // namespace ffcontact::plugin
