// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Per label: which components are prescribed at every vertex of every facet that
/// carries it.
template <int dim>
using PrescribedLabels = std::map<int, std::array<bool, dim>>;

/// @param prescribed  1 where the dof is prescribed [dofs]
template <int dim>
PrescribedLabels<dim> prescribed_labels(const SimplexMesh<dim>& mesh,
                                        const Flags& prescribed) {
  std::array<bool, dim> all;
  all.fill(true);
  PrescribedLabels<dim> labels;
  for (const int label : mesh.boundary_label) labels[label] = all;
  for (Index f = 0; f < mesh.boundary.cols(); ++f)
    for (const int vertex : mesh.boundary.col(f))
      for (int c = 0; c < dim; ++c)
        if (!prescribed[dof_of<dim>(vertex, c)])
          labels[mesh.boundary_label[f]][c] = false;
  return labels;
}

/// @param neumann  one column for each of the boundary
/// @throws std::invalid_argument  if sizes are not those of the mesh, or a traction is not
///                                finite
template <int dim, class Tractions>
void require_fitting(const SimplexMesh<dim>& mesh, const Flags& prescribed,
                     const Tractions& neumann) {
  require_size("prescribed dofs", static_cast<Index>(prescribed.size()),
               dim * mesh.vertices.cols());
  require_size("tractions", neumann.cols(), mesh.boundary.cols());
  require_finite("traction", neumann.reshaped());
}

}  // namespace ffcontact
