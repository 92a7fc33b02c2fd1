// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// The cells of a mesh in trees, each cell below another that it shares a facet with, or below
/// a boundary facet, a root. Breadth first: no path to a root is shorter.
struct CellTrees {
  /// cells, each behind the one above it: those below roots, then part by part those of the
  /// connected parts that have none, each below the first cell of its part
  std::vector<int> cell;
  std::vector<int> facet;  ///< of each cell towards its root; -1: a first cell
  /// places in `cell` where the parts without roots begin, ascending, then its size
  std::vector<int> without_root;
};

/// @param roots  boundary facets
template <int dim>
CellTrees cell_trees(const Facets<dim>& facets, const std::vector<int>& roots);

}  // namespace ffcontact
