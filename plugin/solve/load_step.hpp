// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/gaps_in_reach.hpp"
#include "ffcontact/contact/law/kinetic_friction.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
//
#include "problem/contact_type.hpp"
#include "solve/solve_call.hpp"

/// What a call of contactsolve knows of the load step before.
namespace ffcontact::plugin {

/// The load step before, whose slip kineticfriction= is about.
enum class StepBefore {
  none,
  last_solution,          ///< it is that
  that_of_last_solution,  ///< the same step is solved again
};
/// @param has_previous  does the statement give previous=?
/// @param states        of the nodes in the last solution; empty: there is none
/// @throws std::invalid_argument  if previous= is of a step whose states are not known
StepBefore step_before(const SolveCall& call, bool is_solved, bool has_previous,
                       const ContactStates& states);

/// @throws std::invalid_argument  for loadstep=true without a step before
[[noreturn]] void refuse_load_step();

/// u_t of a solution without what springs back of it, against a tool where this has left it
/// [d - 1 x p].
template <int d>
Matrix<double, d - 1, Dynamic> slid(const LineOrSurface<d>& where,
                                    const SolvedContact<d>& solved) {
  const ContactSolution<d>& found = solved.solution;
  const Matrix<double, d, Dynamic> displaced =
      contact_components(where, found.displacement) +
      solved.law.layer.given_way(lumped_pressures(where, found.force));
  Matrix<double, d - 1, Dynamic> along = displaced.template bottomRows<d - 1>();
  if (solved.moved) along.row(0) -= solved.moved->slid.transpose();
  return along;
}

/// The law of this step: with u_t of the last solution for loadstep=true, and kinetic friction
/// where nodes slipped in the step before.
/// @param last  states of the last solution at the nodes; empty: there is none
/// @param law   as stated
template <int d>
ContactLaw<d> law_of_step(const SolveCall& call, const ContactOf<d>& contact,
                          const ContactStates& last, ContactLaw<d> law) {
  const LineOrSurface<d>& where = contact.problem->contact;
  const KineticFriction& kinetic = contact.problem->kinetic;
  const bool is_solved = contact.solved.has_value(),
             has_previous = law.previous.size() > 0;
  if (call.named.flag(call.stack, "loadstep")) {
    if (is_solved)
      law.previous = without_bonded(law, slid(where, *contact.solved));
    else if (!last.empty() && !has_previous)
      refuse_load_step();
  }
  if (!kinetic.given()) return law;
  switch (step_before(call, is_solved, has_previous, last)) {
    case StepBefore::none: break;
    case StepBefore::last_solution:
      return law_after(last, std::move(law), where, kinetic);
    case StepBefore::that_of_last_solution:
      return with_friction_of(contact.solved->law, std::move(law));
  }
  return law;
}

/// The states that the next step starts from; those of kinetic friction say what moved.
template <int d>
ContactStates states_for_next(const ContactProblem<d>& problem,
                              const SolvedContact<d>& solved,
                              double tolerance) {
  const ContactSolution<d>& solution = solved.solution;
  if (!problem.kinetic.given()) return solution.state;
  const VectorXd& u = solution.displacement;
  return states_of_step(
      solution.state, solved.nodes.slip().rowwise().norm(),
      tolerance *
          largest_displacement(with_gaps_in_reach(solved.law, max_norm(u)), u));
}

}  // namespace ffcontact::plugin
