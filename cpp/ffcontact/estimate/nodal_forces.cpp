// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/nodal_forces.hpp"

#include "ffcontact/equilibrium/boundary_tractions.hpp"

namespace ffcontact {

VectorXd nodal_forces(const Mesh& mesh, const ContactLine& line,
                      const ContactDensities& densities) {
  VectorXd forces = VectorXd::Zero(2 * mesh.vertices.cols());
  for (int e = 0; e < line.edge_count(); ++e) {
    const Vector4d moments = contact_moments(line, densities, e);
    for (int end = 0; end < 2; ++end) {
      const int node = line.edge_node(end, e);
      const Vector2d moment = moments.segment<2>(2 * end);
      forces.segment<2>(2 * line.vertex[node]) += moment;
      visit_opposite(line, node, [&](int vertex, double weight) {
        forces.segment<2>(2 * vertex) -= weight * moment;
      });
    }
  }
  return forces;
}

}  // namespace ffcontact
