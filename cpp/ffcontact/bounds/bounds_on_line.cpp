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
VectorXd twice_psi(const MatchedBodies<2>& bodies, const VectorXd& v,
                   const ContactDensities& rho) {
  return contact_error(bodies.contact(), bodies.body().law, rho, v);
}

template <>
ContactLaw with_twice_the_bound<2>(ContactLaw law) {
  law.multiplier = Multiplier::force;
  law.slip_bound *= 2;
  law.between_nodes.least *= 2;
  law.between_nodes.most *= 2;
  return law;
}

template <>
ContactLaw reflected(const SolvedProblem<2>& solved, const VectorXd& v) {
  ContactLaw law = solved.body.law;
  law.multiplier = Multiplier::force;
  const Matrix2Xd moved = contact_components(solved.contact, v);
  law.gap = on_the_other_side<VectorXd>(law.gap, moved.row(0));
  law.previous = on_the_other_side<VectorXd>(law.previous, moved.row(1));
  return law;
}

template <>
VectorXd cleared(const MatchedBodies<2>& bodies, const VectorXd& v) {
  const ContactLine& line = bodies.contact();
  const ContactLaw& law = bodies.body().law;
  return cleared_between_nodes(
      line, law, admissible_displacement(line, law, v, bodies.prescribed()),
      bodies.prescribed());
}

}  // namespace ffcontact
