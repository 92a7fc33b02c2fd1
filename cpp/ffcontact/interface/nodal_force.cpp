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

VectorXd nodal_load(const ContactLine& line, const Ref<const Matrix2Xd>& force,
                    Index dofs) {
  VectorXd load = VectorXd::Zero(dofs);
  for (int i = 0; i < line.node_count(); ++i)
    add_nodal_force(line, i, line.frame(i) * force.col(i), load);
  return load;
}

}  // namespace ffcontact
