// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/imbalance_cause.hpp"

#include <cmath>
#include <utility>

#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/elastic/inner_forces.hpp"
#include "ffcontact/estimate/bodies/boundary_moments.hpp"
#include "ffcontact/estimate/bodies/nodal_forces.hpp"
#include "ffcontact/estimate/bodies/total_stresses.hpp"
#include "ffcontact/estimate/tractions/missing_loads.hpp"
#include "ffcontact/estimate/tractions/reaction.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// int (C eps(u_h) + tau0) : eps(phi).
VectorXd inner_forces_of(const Mesh& mesh, const SolvedBody<2>& body) {
  return inner_forces<2>(mesh,
                         total_stresses(mesh, body, body.displacement).mean);
}

/// Nodal pressures [2 x p] of the other multiplier.
Matrix2Xd pressures_of_other_multiplier(const ContactLine& line,
                                        const ElasticSystem& system,
                                        const SolvedBody<2>& body) {
  if (body.law.multiplier == Multiplier::force)
    return lumped_pressures(line, forces_of(line, body.multipliers));
  return multiplier_density(line, Multiplier::force, system.prescribed,
                            body.multipliers);
}

/// Takes the given loads off.
/// @param vertices  one column for each column of loads, which has two rows per vertex
template <class Vertices, class Loads>
void subtract_loads(const Vertices& vertices, const Loads& loads,
                    VectorXd& forces) {
  for (Index column = 0; column < vertices.cols(); ++column)
    for (Index k = 0; k < vertices.rows(); ++k)
      forces.segment<2>(2 * vertices(k, column)) -=
          loads.template block<2, 1>(2 * k, column);
}

/// Forces on all dofs that the loads leave over for contact pressures of the other
/// multiplier.
VectorXd left_over_with_other_multiplier(const Mesh& mesh,
                                         const ContactLine& line,
                                         const ElasticSystem& system,
                                         const SolvedBody<2>& body) {
  const Matrix2Xd other = pressures_of_other_multiplier(line, system, body);
  VectorXd left = inner_forces_of(mesh, body) -
                  nodal_forces(mesh, line, edge_densities(line, other));
  subtract_loads(mesh.cells, body.body_loads, left);
  subtract_loads(mesh.boundary, boundary_moments<2>(mesh, body), left);
  return on_free_dofs(system, std::move(left));
}

const char* name_of(Multiplier multiplier) {
  return multiplier == Multiplier::force ? "\"force\"" : "\"pressure\"";
}

/// Are the given pressures those of the other multiplier?
bool fits_other_multiplier(const Imbalance& imbalance, const Mesh& mesh,
                           const ContactLine& line, const ElasticSystem& system,
                           const SolvedBody<2>& body) {
  const VectorXd left =
      left_over_with_other_multiplier(mesh, line, system, body);
  const double scale = max_norm(inner_forces_of(mesh, body));
  return std::abs(left[2 * imbalance.vertex + imbalance.component]) <=
         unbalanced * scale;
}

std::string other_multiplier_in_words(Multiplier own) {
  const Multiplier other =
      own == Multiplier::force ? Multiplier::pressure : Multiplier::force;
  return std::string("pn and pt fit u with multiplier=") + name_of(other) +
         ", not with " + name_of(own);
}

}  // namespace

std::string cause_of(const Imbalance& imbalance,
                     const SolvedProblem<2>& solved) {
  const auto& [topology, line, system, body] = solved;
  const std::string reaction =
      reaction_in_words<2>(imbalance, system, topology.facets, line.edge);
  if (!reaction.empty()) return reaction;
  const bool on_line = (line.vertex.array() == imbalance.vertex).any();
  if (on_line &&
      fits_other_multiplier(imbalance, topology.mesh, line, system, body))
    return other_multiplier_in_words(body.law.multiplier);
  return missing_loads(topology.mesh, imbalance.vertex,
                       on_line ? "on the contact line: give pn and pt of the "
                                 "solution u, and the same label=, normal= and "
                                 "traction="
                               : "");
}

}  // namespace ffcontact
