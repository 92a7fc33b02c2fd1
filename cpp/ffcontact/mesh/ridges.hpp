// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// What facets meet in: the vertices of a plane mesh, the edges of a solid one, with the
/// facets around each.
template <int dim>
struct Ridges {
  Matrix<int, dim - 1, Dynamic> vertices;  ///< ascending, and so are the ridges
  /// facets of ridge r, ascending: facet[facet_start[r] .. facet_start[r + 1])
  std::vector<int> facet_start, facet;
  Matrix<int, dim, Dynamic>
      of_facet;       ///< ridge opposite to each vertex of a facet
  Flags on_boundary;  ///< 1 where two of the facets are on the boundary

  int count() const { return static_cast<int>(vertices.cols()); }
  int facet_count(int ridge) const {
    return facet_start[ridge + 1] - facet_start[ridge];
  }
  Map<const VectorXi> facets_of(int ridge) const {
    return {facet.data() + facet_start[ridge], facet_count(ridge)};
  }
};

/// From one end of an edge to the other [mm].
inline Vector3d edge_vector(const SolidMesh& mesh, const Ridges<3>& edges,
                            int edge) {
  return mesh.vertices.col(edges.vertices(1, edge)) -
         mesh.vertices.col(edges.vertices(0, edge));
}
/// A vertex itself, or halfway between the ends of an edge [mm].
template <int dim>
VectorOf<dim> ridge_middle(const SimplexMesh<dim>& mesh,
                           const Ridges<dim>& ridges, int ridge) {
  VectorOf<dim> sum = mesh.vertices.col(ridges.vertices(0, ridge));
  for (int k = 1; k < dim - 1; ++k)
    sum += mesh.vertices.col(ridges.vertices(k, ridge));
  return sum / (dim - 1);
}

/// @throws std::invalid_argument  if the body touches itself in a single ridge: more than
///                                two boundary facets meet there
template <int dim>
Ridges<dim> ridges_of(const SimplexMesh<dim>& mesh, const Facets<dim>& facets);

}  // namespace ffcontact
