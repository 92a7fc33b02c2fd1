// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// Facets of the boundary that have one of the labels, in the order of their numbers.
/// @throws std::invalid_argument  if a label is on none of them
template <int dim>
std::vector<int> labelled_facets(const SimplexMesh<dim>& mesh,
                                 const Facets<dim>& facets,
                                 const std::vector<int>& labels);

}  // namespace ffcontact
