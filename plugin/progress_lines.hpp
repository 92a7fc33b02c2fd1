// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/progress.hpp"

namespace ffcontact::plugin {

/// Prints a line of what takes long: the beginning of a phase on 3e5 dofs or more, which
/// takes about 2 s, and at most every 2 s a step. Empty at verbosity 0.
/// @param function  of the script
ProgressReport progress_lines(const char* function, long verbosity);

}  // namespace ffcontact::plugin
