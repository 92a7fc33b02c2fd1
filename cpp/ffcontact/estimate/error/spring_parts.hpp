// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"

namespace ffcontact {

/// Adds the springs' part of each boundary facet to its cell.
/// @param of_column  SpringNorms::difference
template <int d>
void add_spring_parts(const Facets<d>& facets, const VectorXd& of_column,
                      VectorXd& local) {
  for (int f = 0; f < facets.count() && of_column.size() > 0; ++f)
    if (facets.on_boundary(f))
      local[facets.cells(0, f)] += of_column[facets.boundary_index[f]];
}

}  // namespace ffcontact
