// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/facets.hpp"
//
#include "freefem/boundary_places.hpp"

namespace ffcontact::plugin {

/// One solid of a joined mesh, and its faces.
struct SolidPart {
  const SolidMesh& mesh;  ///< all solids
  const Facets<3>& faces;
  const Fem2D::Mesh3*
      fem_mesh;  ///< null where other processes hold parts of it
  int body, first_cell, first_boundary;
  const PlacesElsewhere<3>* elsewhere;  ///< null where fem_mesh is not

  /// Is a column of SolidMesh::boundary one of this solid's?
  bool has_boundary(int column) const {
    return column >= first_boundary && column < first_boundary + fem_mesh->nbe;
  }
};

}  // namespace ffcontact::plugin
