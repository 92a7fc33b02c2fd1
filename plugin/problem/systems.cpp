// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/systems.hpp"

#include <utility>

#include "freefem/views.hpp"

namespace ffcontact::plugin {

RowMatrix matrix_of_body(Stack stack, const BodyDofs& bodies, int body,
                         Expression matrix) {
  RowMatrix A = matrix_of(value_of<Matrice_Creuse<double>*>(stack, matrix));
  bodies.require_dofs("A", body, A.rows());
  return A;
}

VectorXd joined_displacement(const BodyDofs& bodies,
                             const std::vector<KN<double>*>& u) {
  VectorXd displacement(bodies.dof_count());
  for (int k = 0; k < bodies.body_count(); ++k) {
    bodies.require_dofs("u", k, u[k]->N());
    displacement.segment(bodies.first_dof(k), bodies.dof_count(k)) =
        vector_of(u[k]);
  }
  return displacement;
}

ElasticSystem joined(std::vector<ElasticSystem> systems) {
  return systems.size() == 1 ? std::move(systems.front())
                             : joined_systems(systems);
}

}  // namespace ffcontact::plugin
