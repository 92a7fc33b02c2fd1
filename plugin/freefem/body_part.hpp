// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/facets.hpp"
//
#include "freefem/boundary_places.hpp"
#include "freefem/held_mesh.hpp"

namespace ffcontact::plugin {

/// One body of a joined mesh.
template <int d>
struct BodyPart {
  const SimplexMesh<d>& mesh;  ///< all bodies
  const Facets<d>& facets;     ///< of all bodies
  const FemMesh<d>* fem_mesh;  ///< null where other processes hold parts of it
  int body, first_cell, first_boundary;
  const PlacesElsewhere<d>* elsewhere;  ///< null where fem_mesh is not

  int cell_count() const { return fem_mesh->nt; }
  int boundary_count() const { return fem_mesh->nbBrdElmts(); }
};

/// A place on a facet of the joined mesh as one of the body that the facet is of.
/// @param weights  of the facet's vertices
template <int d>
BoundaryPlace<d> on_boundary(const BodyPart<d>& part, int facet,
                             const VectorOf<d>& weights) {
  const int column = part.facets.boundary_index[facet];
  BoundaryPlace<d> place{column - part.first_boundary, {}};
  for (int k = 0; k < d; ++k) {
    const int vertex = part.mesh.boundary(k, column);
    place.weights[k] = weights[part.facets.place_of(vertex, facet)];
  }
  return place;
}

}  // namespace ffcontact::plugin
