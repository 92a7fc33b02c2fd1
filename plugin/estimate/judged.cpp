// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/judged.hpp"

#include <utility>

#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact::plugin {

void Judged::factorise(const ContactLine& line) {
  if (!body.stiffness)
    body.stiffness = std::make_shared<const CondensedStiffness>(
        *system, contact_dofs(line, *system));
}

Judged judged_of(const SolvedContact& solved) {
  const ContactSolution<2>& solution = solved.solution;
  Judged judged;
  judged.system = solved.system;
  judged.body.displacement = solution.displacement;
  judged.body.multipliers = solution.pressure;
  judged.body.law = solved.law;
  judged.body.stiffness = solution.stiffness;
  judged.body.body_loads = solved.holding;
  judged.body.tool = solved.driven;
  judged.forces = contact_forces(solved.law, solution);
  judged.contact = solution.contact;
  return judged;
}

Judged judged_of(const ContactProblem<2>& problem, ElasticSystem system,
                 VectorXd displacement, Multiplier multiplier,
                 const Matrix2Xd& pressures) {
  Judged judged;
  judged.system = std::make_shared<const ElasticSystem>(std::move(system));
  SolvedBody<2>& body = judged.body;
  body.displacement = std::move(displacement);
  body.law = problem.law;
  body.law.multiplier = multiplier;
  body.multipliers = multiplier_density(problem.contact, multiplier,
                                        judged.system->prescribed, pressures);
  judged.forces = contact_forces(problem.contact, body.law, pressures);
  return judged;
}

CoulombConstant coulomb_constant_of(const ContactLine& line,
                                    const Judged& judged, StuckNodes stuck) {
  const SolvedBody<2>& body = judged.body;
  const auto contact = contact_of_forces(line, body.law, *judged.system,
                                         *body.stiffness, judged.contact);
  return coulomb_constant_of(line, body.law, *contact, body.displacement,
                             judged.forces, stuck);
}

CoulombBound coulomb_bound_of(const ContactLine& line, const Judged& judged,
                              const Estimate<2>& estimate, StuckNodes stuck) {
  const CoulombConstant constant = coulomb_constant_of(line, judged, stuck);
  const double e = estimate.e + estimate.oscillation;
  return {constant,
          estimate.admissible
              ? coulomb_bound(e, constant.friction, constant.kappa)
              : infinity,
          stuck};
}

}  // namespace ffcontact::plugin
