// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "ffcontact/contact/law/kinetic_friction.hpp"
//
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

/// The law of this step: with u_t of the last solution for loadstep=true, and kinetic friction
/// where nodes slipped in the step before.
/// @param contact  of plane bodies or solids, as a variable of the script holds it
/// @param where    its line or surface
/// @param last     states of the last solution there; empty: there is none
/// @param slid     u_t of the last solution
template <class Contact, class LineOrSurface, class Law, class Slid>
Law law_of_step(const SolveCall& call, const Contact& contact,
                const LineOrSurface& where, const ContactStates& last, Law law,
                const Slid& slid) {
  const KineticFriction& kinetic = contact.problem->kinetic;
  const bool is_solved = contact.solved.has_value(),
             has_previous = law.previous.size() > 0;
  if (call.named.flag(call.stack, "loadstep")) {
    if (is_solved)
      law.previous = slid();
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
/// @param slip  |v_t| of the nodes [mm]
template <class Problem, class Solved>
ContactStates states_for_next(const Problem& problem, const Solved& solved,
                              const VectorXd& slip, double tolerance) {
  const auto& solution = solved.solution;
  if (!problem.kinetic.given()) return solution.state;
  return states_of_step(
      solution.state, slip,
      tolerance * largest_displacement(solved.law, solution.displacement));
}

}  // namespace ffcontact::plugin
