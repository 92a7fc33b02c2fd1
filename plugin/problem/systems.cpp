// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/systems.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/vertex_order.hpp"
//
#include "freefem/views.hpp"

namespace ffcontact::plugin {

template <int d>
RowMatrix matrix_of_body(Stack stack, const BodyDofs& bodies, int body,
                         Expression matrix, const SimplexMesh<d>& mesh) {
  RowMatrix A = matrix_of(value_of<Matrice_Creuse<double>*>(stack, matrix));
  bodies.require_dofs("A", body, A.rows());
  require_order_of_vertices(
      A, mesh.vertices.middleCols(bodies.first_dof(body) / d,
                                  bodies.dof_count(body) / d));
  return A;
}

template RowMatrix matrix_of_body(Stack, const BodyDofs&, int, Expression,
                                  const Mesh&);
template RowMatrix matrix_of_body(Stack, const BodyDofs&, int, Expression,
                                  const SolidMesh&);

VectorXd joined_displacement(const BodyDofs& bodies,
                             const std::vector<KN<double>*>& u) {
  VectorXd displacement(bodies.dof_count());
  for (int k = 0; k < bodies.body_count(); ++k) {
    if (std::count(u.begin(), u.end(), u[k]) > 1)
      refuse("u is one array of several bodies: give each body its own");
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

Multiplier multiplier_of(Stack stack, const NamedArguments& named) {
  return named.choice(
      stack, "multiplier", Multiplier::force,
      {{"pressure", Multiplier::pressure}, {"force", Multiplier::force}});
}

Matrix2Xd pressures_of(const ContactProblem<2>& problem, KN<double>* normal,
                       KN<double>* tangential) {
  const int nodes = problem.contact.node_count();
  if (!problem.side.empty() && normal->N() != nodes)
    refuse("pn has size ", normal->N(),
           " but the line that carries the multipliers has ", nodes,
           " nodes: state the side= that pn belongs to");
  require_size("pn", normal->N(), nodes);
  require_size("pt", tangential->N(), nodes);
  Matrix2Xd pressure(2, nodes);
  pressure.row(0) = vector_of(normal).transpose();
  pressure.row(1) = vector_of(tangential).transpose();
  return pressure;
}

}  // namespace ffcontact::plugin
