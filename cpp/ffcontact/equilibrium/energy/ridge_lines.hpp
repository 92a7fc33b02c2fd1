// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/energy/facet_share.hpp"

namespace ffcontact {

/// The ridges of a share, each in one line, whose stars are solved together.
struct RidgeLines {
  /// those of line l, from one end to the other: ridge[start[l] .. start[l + 1])
  std::vector<int> start{0}, ridge{};

  int count() const { return count_of(start) - 1; }
  void end_line() { start.push_back(count_of(ridge)); }
};

/// Each by itself.
inline RidgeLines single_ridges(const FacetShare& share) {
  RidgeLines lines;
  for (int e = 0; e < count_of(share.ridge); ++e) {
    if (!share.ridge[e]) continue;
    lines.ridge.push_back(e);
    lines.end_line();
  }
  return lines;
}

}  // namespace ffcontact
