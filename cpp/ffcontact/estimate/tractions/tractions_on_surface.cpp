// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "ffcontact/estimate/tractions/carrying_nodes.hpp"
#include "ffcontact/estimate/tractions/contact_tractions.hpp"

namespace ffcontact {

template <>
VectorXd computed_forces(const SolvedProblem<3>& solved) {
  return nodal_load(solved.contact, solved.body.multipliers,
                    solved.system.dof_count());
}

namespace {

/// Those nearest to given ones that balance the loads, or what the contact forces do.
std::optional<ContactTractions<3>> balanced(const SolvedProblem<3>& solved,
                                            const HeldMotions& held,
                                            const CarryingNodes& near) {
  if (held.fields.cols() == 0) return ContactTractions<3>{near.traction};
  for (const VectorXd& resultants : {held.of_loads, held.of_forces}) {
    auto nearest = nearest_in_cone(
        solved.topology.mesh, solved.topology.facets, solved.contact,
        solved.body.law, near.traction, held.fields, resultants, near.carries);
    if (nearest) return ContactTractions<3>{*std::move(nearest)};
  }
  return std::nullopt;
}

}  // namespace

template <>
std::optional<ContactTractions<3>> contact_tractions(
    const SolvedProblem<3>& solved, const MatchedBodies<3>& bodies,
    HeldMotions held, const EstimateSettings<3>&,
    const Ref<const VectorXd>& u_hat) {
  const auto& [topology, surface, system, body] = solved;
  Matrix3Xd lumped = lumped_tractions(body.law, surface, body.multipliers);
  if (!surface.against_a_body())
    lumped = continued_tractions(body.law, surface, body.displacement,
                                 system.prescribed, std::move(lumped));
  auto on_closed =
      balanced(solved, held, carrying_nodes(bodies, u_hat, lumped));
  return on_closed ? on_closed
                   : balanced(solved, held, {std::move(lumped), Flags()});
}

}  // namespace ffcontact
