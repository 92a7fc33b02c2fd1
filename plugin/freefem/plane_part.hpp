// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/mesh.hpp"
//
#include "freefem/boundary_places.hpp"

namespace ffcontact::plugin {

/// One body of a joined mesh.
struct BodyPart {
  const Mesh& mesh;             ///< all bodies
  const Fem2D::Mesh* fem_mesh;  ///< null where other processes hold parts of it
  int body, first_cell, first_boundary;
  const PlacesElsewhere<2>* elsewhere;  ///< null where fem_mesh is not
};

}  // namespace ffcontact::plugin
