// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/nodal_forces.hpp"

#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/interface/nodal_force.hpp"

namespace ffcontact {

VectorXd nodal_forces(const Mesh& mesh, const ContactLine& line,
                      const ContactDensities& densities) {
  VectorXd forces = VectorXd::Zero(2 * mesh.vertices.cols());
  for (int e = 0; e < line.edge_count(); ++e) {
    const Vector4d moments = contact_moments(line, densities, e);
    for (int end = 0; end < 2; ++end)
      add_nodal_force(line, line.edge_node(end, e), moments.segment<2>(2 * end),
                      forces);
  }
  return forces;
}

}  // namespace ffcontact
