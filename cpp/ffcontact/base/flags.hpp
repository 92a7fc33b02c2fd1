// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace ffcontact {

/// 0 or 1 of each dof, row, node or cell. Bytes, as threads may write neighbours.
using Flags = std::vector<char>;

}  // namespace ffcontact
