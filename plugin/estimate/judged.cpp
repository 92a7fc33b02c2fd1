// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/judged.hpp"

#include <utility>

#include "ffcontact/contact/law/nodal_pressures.hpp"

namespace ffcontact::plugin {

namespace {

/// But for the multipliers.
template <int d>
Judged<d> judged_body(const SolvedContact<d>& solved) {
  const ContactSolution<d>& solution = solved.solution;
  Judged<d> judged;
  judged.system = solved.system;
  judged.body.displacement = solution.displacement;
  judged.body.law = solved.law;
  judged.body.stiffness = solution.stiffness;
  judged.body.body_loads = solved.holding;
  if (solved.moved) judged.body.tool = solved.moved->tool;
  return judged;
}

}  // namespace

Judged<2> judged_of(const SolvedContact<2>& solved) {
  Judged<2> judged = judged_body(solved);
  judged.body.multipliers = solved.solution.pressure;
  judged.forces = contact_forces(solved.law, solved.solution);
  judged.contact = solved.solution.contact;
  return judged;
}

Judged<3> judged_of(const SolvedContact<3>& solved) {
  Judged<3> judged = judged_body(solved);
  judged.body.multipliers = solved.solution.force;
  judged.state = solved.solution.state;
  return judged;
}

Judged<2> judged_of(const ContactProblem<2>& problem, ElasticSystem system,
                    VectorXd displacement, Multiplier multiplier,
                    const Matrix2Xd& pressures) {
  Judged<2> judged;
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

void factorise(const ContactLine& line, Judged<2>& judged) {
  if (!judged.body.stiffness)
    judged.body.stiffness = std::make_shared<const CondensedStiffness>(
        *judged.system, contact_dofs(line, *judged.system));
}

CoulombConstant coulomb_constant_of(const ContactLine& line,
                                    const Judged<2>& judged, StuckNodes stuck) {
  const SolvedBody<2>& body = judged.body;
  const auto contact = contact_of_forces(line, body.law, *judged.system,
                                         *body.stiffness, judged.contact);
  return coulomb_constant_of(line, body.law, *contact, body.displacement,
                             judged.forces, stuck);
}

}  // namespace ffcontact::plugin
