// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/nodal_force.hpp"

namespace ffcontact {

void add_nodal_force(const ContactLine& line, int node, const Vector2d& force,
                     VectorXd& forces) {
  forces.segment<2>(2 * line.vertex[node]) += force;
  visit_opposite(line, node, [&](int vertex, double weight) {
    forces.segment<2>(2 * vertex) -= weight * force;
  });
}

}  // namespace ffcontact
