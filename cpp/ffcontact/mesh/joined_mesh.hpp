// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Several bodies as one mesh of separate parts: all that is done vertex by vertex, facet
/// by facet or cell by cell is then done for all bodies at once. Vertices, cells and
/// boundary facets of body k follow those of body k - 1; labels are shifted so that no
/// two bodies share one. Coordinates are those of take_from_near_origin.
template <int dim>
struct JoinedBodies {
  SimplexMesh<dim> mesh;
  std::vector<int> first_vertex, first_cell,
      first_boundary;  ///< of each body, and the total at the end [bodies + 1]
  int label_stride = 0;

  int body_count() const { return static_cast<int>(first_vertex.size()) - 1; }
  /// The joined mesh's label for a label of one body.
  int label(int body, int own_label) const {
    return own_label + body * label_stride;
  }
};

using JoinedMesh = JoinedBodies<2>;
using JoinedSolids = JoinedBodies<3>;

template <int dim>
JoinedBodies<dim> joined_mesh(const std::vector<SimplexMesh<dim>>& bodies);

}  // namespace ffcontact
