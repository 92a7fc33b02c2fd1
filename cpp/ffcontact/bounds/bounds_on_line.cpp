// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/contact_of_bounds.hpp"
#include "ffcontact/estimate/displacement/admissible_displacement.hpp"
#include "ffcontact/estimate/error/contact_error.hpp"

namespace ffcontact {

template <>
VectorXd nodal_forces(const MatchedBodies<2>& bodies,
                      const ContactDensities& rho) {
  return bodies.solved_forces(rho);
}

template <>
VectorXd twice_psi<2>(const MatchedBodies<2>& bodies, const ContactLaw<2>& law,
                      const VectorXd& v, const ContactDensities& rho) {
  return contact_error(bodies.contact(), law, rho, v);
}

template <>
ContactLaw<2> with_twice_the_bound<2>(ContactLaw<2> law) {
  law.multiplier = Multiplier::force;
  law.slip_bound *= 2;
  law.between_nodes.least *= 2;
  law.between_nodes.most *= 2;
  return law;
}

template <>
ContactLaw<2> reflected(const SolvedProblem<2>& solved, const VectorXd& v) {
  ContactLaw<2> law = solved.body.law;
  law.multiplier = Multiplier::force;
  const Matrix2Xd moved = contact_components(solved.contact, v);
  law.gap = on_the_other_side<VectorXd>(law.gap, moved.row(0));
  law.previous = on_the_other_side<VectorXd>(law.previous, moved.row(1));
  return law;
}

template <>
VectorXd cleared(const MatchedBodies<2>& bodies,
                 const ContactConditions<2>& conditions, const VectorXd& v) {
  const auto& [line, law] = conditions;
  return cleared_between_nodes(
      line, law, admissible_displacement(line, law, v, bodies.prescribed()),
      bodies.prescribed());
}

template <>
double depth_of(const MatchedBodies<2>&, const ContactConditions<2>& conditions,
                const VectorXd& v) {
  return deepest_node(conditions.contact, conditions.law, v).depth;
}

}  // namespace ffcontact
