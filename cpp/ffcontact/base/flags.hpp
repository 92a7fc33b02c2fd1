// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace ffcontact {

/// 0 or 1 of each dof, row, node or cell. Bytes, as threads may write neighbours.
using Flags = std::vector<char>;

/// A vector or a matrix, by columns, with 0 in the entries that are flagged.
template <class Entries>
Entries without(const Flags& flags, Entries entries) {
  for (std::size_t k = 0; k < flags.size(); ++k)
    if (flags[k]) entries.data()[k] = 0;
  return entries;
}

}  // namespace ffcontact
