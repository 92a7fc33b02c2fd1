// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/contact_solution.hpp"

#include <algorithm>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/balance.hpp"
#include "ffcontact/contact/convex_contact.hpp"
#include "ffcontact/contact/feasibility.hpp"
#include "ffcontact/contact/fixed_point.hpp"
#include "ffcontact/contact/nodal_pressures.hpp"
#include "ffcontact/contact/refinement.hpp"

namespace ffcontact {

namespace {

/// Newton; where it does not converge, the convex minimum, or with Coulomb's law the
/// fixed point helped by Newton.
FixedPointResult safeguarded_newton(const CondensedContact& contact, const NodalLaw& law,
                                    const std::vector<ContactState>& start,
                                    const NewtonSettings& settings) {
  if (law.is_convex()) return {solve_convex(contact, law, start, settings), {}};
  FixedPointResult newton{active_set_newton(contact, law, start, settings), {}};
  const int systems = newton.answer.iterations, left = settings.max_iterations - systems;
  if (newton.answer.status == ContactStatus::converged || left <= 0) return newton;
  FixedPointResult path =
      fixed_point(contact, law, start, {left, settings.tolerance}, true);
  const bool better = path.answer.status == ContactStatus::converged ||
                      path.answer.violation < newton.answer.violation;
  path.answer.iterations += systems;
  newton.answer.iterations = path.answer.iterations;
  return better ? path : newton;
}

/// Displacement of the whole body, refined until rounding is all that is left of the
/// residual.
BodyAnswer body_answer(const ContactLine& line, const ContactLaw& law,
                       const ElasticSystem& system, const CondensedStiffness& stiffness,
                       const CondensedContact& contact, const ActiveSetResult& condensed,
                       double& residual) {
  constexpr double rounding = 1e-12;
  constexpr int most_steps = 3;
  const NodalLaw nodal = nodal_law(law, line);
  const VectorXd kept = kept_displacement(contact, condensed.v(contact.primary),
                                          condensed.P(contact.dependent));
  BodyAnswer answer{stiffness.extended(system.load, kept) + system.prescribed_value,
                    condensed.P};
  residual = residual_defect(line, law, system, answer);
  for (int k = 0; k < most_steps && residual > rounding &&
                  condensed.status == ContactStatus::converged;
       ++k) {
    BodyAnswer next =
        refined(line, law, system, stiffness, contact, condensed.state, answer);
    put_into_law(nodal, condensed.state, next.P);
    const double defect = residual_defect(line, law, system, next);
    if (!(defect < 0.5 * residual)) break;
    answer = std::move(next);
    residual = defect;
  }
  return answer;
}

/// A state as answers have it.
ContactState answered(ContactState state) {
  if (is_open(state)) return ContactState::open;
  if (!is_limited(state)) return state;
  return slip_sign(state) > 0 ? ContactState::slip_forward : ContactState::slip_backward;
}

/// The pressures and forces of the multipliers that were solved for.
void put_multipliers(const ContactLine& line, const ContactLaw& law,
                     const std::vector<char>& prescribed, const Matrix2Xd& P,
                     ContactSolution& solution) {
  if (law.multiplier == Multiplier::pressure) {
    solution.pressure = P;
    solution.force = nodal_forces_of(line, law, P.reshaped());
  } else {
    solution.force = P;
    solution.pressure = consistent_pressures(line, prescribed, P);
  }
}

}  // namespace

const char* in_words(ContactStatus status) {
  switch (status) {
    case ContactStatus::converged: return "converged";
    case ContactStatus::cycled: return "the active set cycles";
    case ContactStatus::singular: return "the body slides or rotates freely";
    case ContactStatus::not_converged: return "the iterations are used up";
    case ContactStatus::inaccurate: return "rounding exceeds the tolerance";
  }
  return "";
}

std::vector<ContactState> states_at(const ContactLine& line,
                                    const Ref<const VectorXd>& old_abscissa,
                                    const std::vector<ContactState>& old_state) {
  require_size("abscissa of the initial states", old_abscissa.size(),
               static_cast<Index>(old_state.size()));
  if (old_state.empty()) return {};
  std::vector<ContactState> states;
  for (double s : line.abscissa) {
    Index nearest;
    (old_abscissa.array() - s).abs().minCoeff(&nearest);
    states.push_back(old_state[nearest]);
  }
  return states;
}

ContactSolution solve_contact(const Mesh& mesh, const ContactLine& line,
                              const ContactLaw& law, const ElasticSystem& system,
                              const ContactSettings& settings) {
  require_valid(law, line);
  require_size("A", system.dof_count(), 2 * mesh.vertices.cols());
  if (settings.max_iterations < 1)
    refuse("maxit must be at least 1, got ", settings.max_iterations);
  std::vector<ContactState> start = settings.initial_state;
  if (start.empty()) start.assign(line.node_count(), ContactState::stick);
  require_size("initial state", static_cast<Index>(start.size()), line.node_count());
  require_feasible(mesh, line, law, system);
  require_balance(mesh, line, law, system);

  // 1. The body as the contact line sees it, P = S v - g.
  const auto stiffness = settings.stiffness ? settings.stiffness
                                            : std::make_shared<const CondensedStiffness>(
                                                  system, contact_dofs(line, system));
  const CondensedContact contact = condensed_contact(line, law, system, *stiffness);

  // 2. The conditions of Prop. 3.4 / 3.5.
  const NodalLaw nodal = nodal_law(law, line);
  const NewtonSettings limits{settings.max_iterations, settings.tolerance};
  FixedPointResult condensed = settings.solver == ContactSolver::newton
                                   ? safeguarded_newton(contact, nodal, start, limits)
                                   : fixed_point(contact, nodal, start, limits);
  const ActiveSetResult& answer = condensed.answer;

  // 3. Back to the whole body.
  ContactSolution solution;
  solution.stiffness = stiffness;
  solution.status = answer.status;
  for (ContactState state : answer.state) solution.state.push_back(answered(state));
  solution.iterations = answer.iterations;
  solution.history = std::move(condensed.history);
  BodyAnswer whole =
      body_answer(line, law, system, *stiffness, contact, answer, solution.residual);
  solution.displacement = std::move(whole.displacement);
  const Matrix2Xd P = whole.P.reshaped(2, line.node_count());
  put_multipliers(line, law, system.prescribed, P, solution);

  // 4. What the theory promises, measured.
  solution.complementarity =
      complementarity_defect(line, law, solution.displacement, P,
                             motion_scale(contact, answer.v), idle_rows(contact));
  const bool fulfilled = solution.complementarity <= settings.tolerance &&
                         solution.residual <= settings.tolerance;
  if (fulfilled && solution.status != ContactStatus::singular)
    solution.status = ContactStatus::converged;
  if (!fulfilled && solution.status == ContactStatus::converged)
    solution.status = ContactStatus::inaccurate;
  return solution;
}

}  // namespace ffcontact
