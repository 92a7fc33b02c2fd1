// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// The edges of a triangulation and what lies beside them.
///
/// An edge runs from vertices(0) to vertices(1) with cells(0) on its left. Its normal
/// points to the right, so that a boundary edge has the outward normal and runs
/// counter-clockwise around the body. For a traction F on the edge, eta F with eta = +1
/// acts on the left triangle and eta = -1 on the right one [CHH01, 4.2.2].
struct Edges {
  Matrix2Xi vertices;
  Matrix2Xi cells;          ///< left, right; right is -1 on the boundary
  Matrix3Xi of_cell;        ///< edge opposite to each local vertex
  Matrix3Xd eta;            ///< +1 or -1, same layout as of_cell
  VectorXi boundary_index;  ///< column of Mesh::boundary, or -1

  int count() const { return static_cast<int>(vertices.cols()); }
  bool on_boundary(int edge) const { return cells(1, edge) < 0; }
};

/// A vector turned clockwise by a right angle.
inline Vector2d turned_right(const Vector2d& v) { return {v.y(), -v.x()}; }

/// @throws std::invalid_argument  if an edge has more than two triangles, two triangles
///                                on the same side, or a boundary
///                                edge of the body is not listed in Mesh::boundary
Edges edges_of(const Mesh& mesh);

/// Vector from the first to the second vertex of an edge [mm].
Vector2d edge_vector(const Mesh& mesh, const Edges& edges, int edge);

/// Unit normal of an edge: outward on the boundary, pointing from left to right inside.
Vector2d edge_normal(const Mesh& mesh, const Edges& edges, int edge);

}  // namespace ffcontact
