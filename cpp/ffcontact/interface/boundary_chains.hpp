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

/// All of the boundary, whatever its labels, in the order of their numbers.
std::vector<int> boundary_edges(const Edges& edges);

/// Edges ordered into chains: each starts where no edge ends, or where bodies touch
/// themselves in a vertex, and ends at such a one; closed loops start at a corner, the
/// first of their vertices where they turn about as much as anywhere.
std::vector<std::vector<int>> boundary_chains(const Mesh& mesh,
                                              const Edges& edges,
                                              const std::vector<int>& boundary);

/// The vertices along a chain [2 x edges + 1].
Matrix2Xd points_of(const Mesh& mesh, const Edges& edges,
                    const std::vector<int>& chain);

/// Both vertices of each edge as who made the mesh knows them [2 x 2 edges].
Matrix2Xd places_of(const Mesh& mesh, const Edges& edges,
                    const std::vector<int>& boundary);

}  // namespace ffcontact
