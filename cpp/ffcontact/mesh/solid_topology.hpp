// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/facet_topology.hpp"

namespace ffcontact {

/// The tetrahedra at each vertex, ascending.
struct SolidStars {
  /// those of vertex v: cell[start[v] .. start[v + 1])
  std::vector<int> start, cell;
  std::vector<int> local;  ///< local number of v in each of them

  int count(int vertex) const { return start[vertex + 1] - start[vertex]; }
  Map<const VectorXi> cells_of(int vertex) const {
    return {cell.data() + start[vertex], count(vertex)};
  }
};

/// A solid with its faces, edges and stars: made once, and handed on as one.
struct SolidTopology {
  SolidMesh mesh;
  Facets<3> faces;
  Ridges<3> edges;
  SolidStars stars;

  operator FacetTopology<3>() const { return {mesh, faces, edges}; }
};

/// @throws std::invalid_argument  as facets_of and ridges_of
SolidTopology topology_of(SolidMesh mesh);

}  // namespace ffcontact
