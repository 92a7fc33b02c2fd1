// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/coulomb.hpp"

#include <algorithm>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/contact/uniqueness/critical_friction.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact::plugin {

ContactForces contact_forces(const ContactLaw<2>& law,
                             const ContactSolution<2>& solution) {
  return {
      law.multiplier == Multiplier::force ? solution.force : solution.pressure,
      solution.force};
}

ContactForces contact_forces(const ContactLine& line, const ContactLaw<2>& law,
                             const Matrix2Xd& given) {
  if (law.multiplier == Multiplier::pressure)
    return {given, forces_of(line, given)};
  const Matrix2Xd force = lumped_forces(line, given);
  return {force, force};
}

StuckNodes stuck_nodes_of(Stack stack, const NamedArguments& named) {
  return named.choice(
      stack, "stick", StuckNodes::may_slip,
      {{"free", StuckNodes::may_slip}, {"held", StuckNodes::stick}});
}

const char* stuck_in_words(StuckNodes stuck) {
  return stuck == StuckNodes::stick ? "sticking nodes held"
                                    : "sticking nodes free to slip";
}

CoulombConstant coulomb_constant_of(const ContactLine& line,
                                    const ContactLaw<2>& law,
                                    const CondensedContact& contact,
                                    const VectorXd& displacement,
                                    const ContactForces& forces,
                                    StuckNodes stuck) {
  const NodalLaw nodal = nodal_law(law, line);
  const SlipPattern pattern = slip_pattern(
      nodal, forces.multiplier, forces.force,
      displacement_against_foundation(
          line, on_layer(law, lumped_pressures(line, forces.force)),
          displacement)
          .row(1));
  const double mu = largest_friction(nodal);
  if (mu == 0) return {0, 0};
  if (law.has_bonded()) return {infinity, mu};  // not derived
  const Matrix2Xd& between = law.between_nodes.most;
  const double largest =
      between.size() > 0 ? std::max(mu, between.maxCoeff()) : mu;
  return {coulomb_constant(contact, pattern, mu, stuck), largest};
}

std::shared_ptr<const CondensedContact> contact_of_forces(
    const ContactLine& line, ContactLaw<2> law, const ElasticSystem& system,
    const CondensedStiffness& stiffness,
    const std::shared_ptr<const CondensedContact>& solved) {
  if (solved && law.multiplier == Multiplier::force) return solved;
  law.multiplier = Multiplier::force;
  return std::make_shared<const CondensedContact>(
      condensed_contact(line, law, system, stiffness));
}

double critical_friction_of(const ContactProblem<2>& problem,
                            const SolvedContact<2>& solved) {
  const auto& solution = solved.solution;
  return critical_friction(
      *solution.contact, nodal_law(solved.law, problem.contact), solution.state,
      contact_forces(solved.law, solution).multiplier.reshaped());
}

}  // namespace ffcontact::plugin
