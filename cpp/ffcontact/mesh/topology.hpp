// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/facet_topology.hpp"

namespace ffcontact {

/// The cells at each vertex, ascending.
struct Stars {
  /// those of vertex v: cell[start[v] .. start[v + 1])
  std::vector<int> start, cell;
  std::vector<int> local;  ///< local number of v in each of them

  int count(int vertex) const { return start[vertex + 1] - start[vertex]; }
  Map<const VectorXi> cells_of(int vertex) const {
    return {cell.data() + start[vertex], count(vertex)};
  }
};

/// A mesh with its facets, ridges and stars: made once, and handed on as one.
template <int d>
struct Topology {
  SimplexMesh<d> mesh;
  Facets<d> facets;
  Ridges<d> ridges;
  Stars stars;

  operator FacetTopology<d>() const { return {mesh, facets, ridges}; }
};

/// @throws std::invalid_argument  as facets_of and ridges_of
template <int d>
Topology<d> topology_of(SimplexMesh<d> mesh);

/// @param facets  facets_of the mesh
/// @throws std::invalid_argument  as ridges_of
template <int d>
Topology<d> topology_of(SimplexMesh<d> mesh, Facets<d> facets);

/// Calls of_facet(facet) for the boundary facets at a vertex.
template <int d, class OfFacet>
void for_boundary_facets(const Topology<d>& topology, int vertex,
                         const OfFacet& of_facet) {
  const auto& [mesh, facets, ridges, stars] = topology;
  for (int k = stars.start[vertex]; k < stars.start[vertex + 1]; ++k)
    for (int j = 1; j <= d; ++j) {
      const int opposite = (stars.local[k] + j) % (d + 1),
                facet = facets.of_cell(opposite, stars.cell[k]);
      if (facets.on_boundary(facet)) of_facet(facet);
    }
}

}  // namespace ffcontact
