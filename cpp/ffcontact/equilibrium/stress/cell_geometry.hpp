// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>

#include "ffcontact/mesh/mesh.hpp"

/// A triangle or a tetrahedron, its facets, and the d + 1 subcells that its barycentre G
/// cuts it into.
namespace ffcontact {

/// 0 and the unit vectors.
template <int d>
CellCorners<d> reference_cell() {
  CellCorners<d> corners;
  corners << VectorOf<d>::Zero(), MatrixOf<d>::Identity();
  return corners;
}

/// B of Piola's map x = B xi + x_0 from the reference cell.
template <int d>
MatrixOf<d> piola_matrix(const CellCorners<d>& corners) {
  return corners.template rightCols<d>().colwise() - corners.col(0);
}

constexpr double factorial(int n) { return n > 1 ? n * factorial(n - 1) : 1; }

/// [mm^d], positive in the order that SimplexMesh::cells asks for.
template <int d>
double volume_of(const CellCorners<d>& corners) {
  return piola_matrix(corners).determinant() / factorial(d);
}

/// Vertex k + 1 + j of facet k.
template <int d>
constexpr int vertex_of_facet(int k, int j) {
  return (k + 1 + j) % (d + 1);
}
/// The j with vertex_of_facet(k, j) == vertex.
template <int d>
constexpr int place_on_facet(int k, int vertex) {
  return (vertex + d - k) % (d + 1);
}

/// Columns A_k n_k of the facets, n outward [mm^(d-1)].
template <int d>
CellCorners<d> facet_vectors(const CellCorners<d>& corners) {
  CellCorners<d> vectors;
  for (int k = 0; k <= d; ++k) {
    const MatrixOf<d> facet = corners(Eigen::all, facet_corners<d>[k]);
    vectors.col(k) = facet_vector(facet);
  }
  return vectors;
}

/// Corners k+1, .., k+d, G of subcell k.
template <int d>
CellCorners<d> subcell(const CellCorners<d>& corners, int k) {
  CellCorners<d> x;
  for (int j = 0; j < d; ++j) x.col(j) = corners.col(vertex_of_facet<d>(k, j));
  x.col(d) = corners.rowwise().mean();
  return x;
}

}  // namespace ffcontact
