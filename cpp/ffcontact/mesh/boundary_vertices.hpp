// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/flags.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Which vertices have a facet on the boundary? [vertices]
template <int dim>
Flags boundary_vertices(const SimplexMesh<dim>& mesh) {
  Flags on_boundary(mesh.vertex_count(), 0);
  for (const int v : mesh.boundary.reshaped()) on_boundary[v] = 1;
  return on_boundary;
}

}  // namespace ffcontact
