// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Nodes gathered with their neighbours, as multigrid methods do (Vanek, Mandel, Brezina
/// 1996): some seven each on a surface of triangles.
struct Aggregates {
  std::vector<int> of_node;  ///< [nodes]
  std::vector<int> first;    ///< node of each [aggregates]

  int count() const { return static_cast<int>(first.size()); }
};

/// A node with all its neighbours where none of these is taken; others go with a neighbour.
/// @param neighbours  an entry for each pair, both ways [nodes x nodes]
Aggregates aggregates(const SparseMatrix& neighbours);

}  // namespace ffcontact
