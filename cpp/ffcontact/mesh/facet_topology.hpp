// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/facets.hpp"
#include "ffcontact/mesh/ridges.hpp"

namespace ffcontact {

/// A mesh with its facets and the ridges in which these meet: vertices of triangles, edges of
/// tetrahedra. All of it belongs to someone else.
template <int d>
struct FacetTopology {
  const SimplexMesh<d>& mesh;
  const Facets<d>& facets;
  const Ridges<d>& ridges;

  Matrix<double, d, d + 1> corners(int cell) const {
    Matrix<double, d, d + 1> points;
    for (int k = 0; k <= d; ++k) points.col(k) = mesh.corner(cell, k);
    return points;
  }
  MatrixOf<d> facet_corners(int facet) const {
    const Matrix<int, d, 1> vertices = facets.vertices.col(facet);
    return facet_points<d>(mesh, vertices);
  }
};

}  // namespace ffcontact
