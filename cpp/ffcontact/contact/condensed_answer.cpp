// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/condensed_answer.hpp"

#include "ffcontact/contact/active_set/convex_contact.hpp"

namespace ffcontact {

namespace {

/// Newton; where it does not converge, the convex minimum, or with Coulomb's law the
/// fixed point helped by Newton.
FixedPointResult safeguarded_newton(const CondensedContact& contact,
                                    const NodalLaw& law,
                                    const ContactStates& start,
                                    const NewtonSettings& settings) {
  if (law.is_convex()) return {solve_convex(contact, law, start, settings), {}};
  FixedPointResult newton{active_set_newton(contact, law, start, settings), {}};
  const int left = settings.max_iterations - newton.answer.iterations;
  if (newton.answer.status == ContactStatus::converged || left <= 0)
    return newton;
  FixedPointResult path =
      fixed_point(contact, law, start, settings.with_at_most(left), true);
  const bool better = path.answer.is_better_than(newton.answer);
  const int systems = newton.answer.iterations + path.answer.iterations;
  if (better) newton = std::move(path);
  newton.answer.iterations = systems;
  return newton;
}

}  // namespace

std::shared_ptr<const CondensedStiffness> prepared_stiffness(
    const std::vector<int>& contact_dofs, const ElasticSystem& system,
    const ContactSettings& settings, Precision precision) {
  if (settings.stiffness) return settings.stiffness;
  tell(settings.report,
       {"factorisation", 0, "dofs", static_cast<double>(system.dof_count())});
  if (settings.factorise)
    return settings.factorise(system, contact_dofs, precision);
  return std::make_shared<const CondensedStiffness>(system, contact_dofs,
                                                    precision, settings.report);
}

/// By the chosen solver, from the chosen states.
FixedPointResult condensed_answer(const CondensedContact& contact,
                                  const NodalLaw& law,
                                  const ContactSettings& settings) {
  const ContactStates start = settings.first_states(law.node_count());
  const NewtonSettings limits{settings.max_iterations, settings.tolerance,
                              settings.report};
  if (law.is_bonded())  // linear: one step
    return {active_set_newton(contact, law, start, limits), {}};
  return settings.solver == ContactSolver::newton
             ? safeguarded_newton(contact, law, start, limits)
             : fixed_point(contact, law, start, limits);
}

}  // namespace ffcontact
