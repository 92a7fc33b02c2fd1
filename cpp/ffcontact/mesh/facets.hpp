// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// The facets of a mesh, which are the edges of triangles or the faces of tetrahedra, and
/// what lies beside them.
///
/// The vertices of a facet are in the order in which its normal (facet_vector) points
/// from cells(0) to cells(1), and outward on the boundary: an edge has cells(0) on its
/// left, a boundary edge runs counter-clockwise around the body. For a traction F on the
/// facet, eta F with eta = +1 acts on cells(0) and eta = -1 on cells(1) [CHH01, 4.2.2].
template <int dim>
struct Facets {
  Matrix<int, dim, Dynamic> vertices;
  Matrix2Xi cells;  ///< both sides; the second is -1 on the boundary
  Matrix<int, dim + 1, Dynamic>
      of_cell;  ///< facet opposite to each local vertex
  Matrix<signed char, dim + 1, Dynamic>
      eta;                  ///< +1 or -1, same layout as of_cell
  VectorXi boundary_index;  ///< column of Mesh::boundary, or -1

  int count() const { return static_cast<int>(vertices.cols()); }
  bool on_boundary(int facet) const { return cells(1, facet) < 0; }
  /// Which facet of a cell, which has it.
  int side_of_cell(int facet, int cell) const {
    int k = 0;
    while (of_cell(k, cell) != facet) ++k;
    return k;
  }
  /// The place of a vertex among those of a facet, which has it.
  int place_of(int vertex, int facet) const {
    int place = 0;
    while (vertices(place, facet) != vertex) ++place;
    return place;
  }
};

/// In the order of their vertices, the lowest first.
/// @throws std::invalid_argument  if a facet has more than two cells, two cells on the
///                                same side, or a boundary facet of the body is not
///                                listed in SimplexMesh::boundary
template <int dim>
Facets<dim> facets_of(const SimplexMesh<dim>& mesh);

template <int dim>
MatrixOf<dim> facet_points(const SimplexMesh<dim>& mesh,
                           const Facets<dim>& facets, int facet) {
  return mesh.vertices(Eigen::all, facets.vertices.col(facet));
}

/// Length of an edge [mm], area of a face [mm^2].
template <int dim>
double facet_measure(const SimplexMesh<dim>& mesh, const Facets<dim>& facets,
                     int facet);

/// Unit normal of a facet: outward on the boundary, from cells(0) to cells(1) inside.
template <int dim>
VectorOf<dim> facet_normal(const SimplexMesh<dim>& mesh,
                           const Facets<dim>& facets, int facet);

}  // namespace ffcontact
