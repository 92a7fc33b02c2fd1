// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/factor/supernodes.hpp"

namespace ffcontact {

/// An elimination tree cut into subtrees, which do not depend on each other, and what is
/// above them.
struct Subtrees {
  std::vector<std::vector<int>>
      supernodes;          ///< of each, ascending; most work first
  std::vector<int> above;  ///< ascending
};

/// Products that the elimination of a supernode takes.
double work_of(const Supernodes& nodes, int s);

/// Subtrees none of which is more than about the given share of the work.
Subtrees subtrees(const Supernodes& nodes, double share);

}  // namespace ffcontact
