// SPDX-License-Identifier: GPL-3.0-or-later
#include "systems.hpp"

#include <utility>

namespace ffcontact::plugin {

RowMatrix matrix_of_body(Stack stack, const ContactProblem& problem, int body,
                         Expression matrix) {
  RowMatrix A = matrix_of(value_of<Matrice_Creuse<double>*>(stack, matrix));
  problem.require_dofs("A", body, A.rows());
  return A;
}

VectorXd joined_displacement(const ContactProblem& problem,
                             const std::vector<KN<double>*>& u) {
  VectorXd displacement(problem.first_dof(problem.body_count()));
  for (int k = 0; k < problem.body_count(); ++k) {
    problem.require_dofs("u", k, u[k]->N());
    displacement.segment(problem.first_dof(k), problem.dof_count(k)) =
        vector_of(u[k]);
  }
  return displacement;
}

ElasticSystem joined(std::vector<ElasticSystem> systems) {
  return systems.size() == 1 ? std::move(systems.front())
                             : joined_systems(systems);
}

}  // namespace ffcontact::plugin
