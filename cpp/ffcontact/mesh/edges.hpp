// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// The edges of a triangulation: an edge runs from vertices(0) to vertices(1) with
/// cells(0) on its left; its normal points to the right.
using Edges = Facets<2>;

/// @throws std::invalid_argument  as facets_of
inline Edges edges_of(const Mesh& mesh) { return facets_of(mesh); }

/// A vector turned clockwise by a right angle.
inline Vector2d turned_right(const Vector2d& v) { return {v.y(), -v.x()}; }

/// Vector from the first to the second vertex of an edge [mm].
inline Vector2d edge_vector(const Mesh& mesh, const Edges& edges, int edge) {
  return mesh.vertices.col(edges.vertices(1, edge)) -
         mesh.vertices.col(edges.vertices(0, edge));
}

/// Unit normal of an edge: outward on the boundary, pointing from left to right inside.
inline Vector2d edge_normal(const Mesh& mesh, const Edges& edges, int edge) {
  return facet_normal(mesh, edges, edge);
}

}  // namespace ffcontact
