// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/edges.hpp"

namespace ffcontact {

/// Boundary edges in the order of their numbers.
/// @throws std::invalid_argument  if `labels` is empty or one of them is on no boundary
///                                edge of the body
std::vector<int> labelled_boundary(const Mesh& mesh, const Edges& edges,
                                   const std::vector<int>& labels);

/// Edges ordered into chains: each starts where no edge ends, closed loops at a corner,
/// the first of their vertices where they turn about as much as anywhere.
std::vector<std::vector<int>> boundary_chains(const Mesh& mesh,
                                              const Edges& edges,
                                              const std::vector<int>& boundary);

}  // namespace ffcontact
