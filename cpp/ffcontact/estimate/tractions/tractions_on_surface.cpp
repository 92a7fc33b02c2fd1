// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "ffcontact/estimate/tractions/contact_tractions.hpp"

namespace ffcontact {

template <>
VectorXd computed_forces(const SolvedProblem<3>& solved) {
  return nodal_load(solved.contact, solved.body.multipliers,
                    solved.system.dof_count());
}

template <>
std::optional<ContactTractions<3>> contact_tractions(
    const SolvedProblem<3>& solved, const MatchedBodies<3>&, HeldMotions held,
    const EstimateSettings<3>&, const Ref<const VectorXd>&) {
  const auto& [topology, surface, system, body] = solved;
  Matrix3Xd lumped = lumped_tractions(body.law, surface, body.multipliers);
  if (!surface.against_a_body())
    lumped = continued_tractions(body.law, surface, body.displacement,
                                 system.prescribed, std::move(lumped));
  if (held.fields.cols() == 0) return ContactTractions<3>{std::move(lumped)};
  for (const VectorXd& resultants : {held.of_loads, held.of_forces}) {
    auto nearest = nearest_in_cone(topology.mesh, topology.facets, surface,
                                   body.law, lumped, held.fields, resultants);
    if (nearest) return ContactTractions<3>{*std::move(nearest)};
  }
  return std::nullopt;
}

}  // namespace ffcontact
