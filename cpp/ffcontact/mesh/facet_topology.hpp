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

  CellCorners<d> corners(int cell) const { return corners_of(mesh, cell); }
  MatrixOf<d> facet_corners(int facet) const {
    return facet_points(mesh, facets, facet);
  }
};

}  // namespace ffcontact
