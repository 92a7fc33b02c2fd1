// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/load_step.hpp"

#include "ffcontact/base/require.hpp"

namespace ffcontact::plugin {

StepBefore step_before(const SolveCall& call, bool is_solved, bool has_previous,
                       const ContactStates& states) {
  if (is_solved && call.named.flag(call.stack, "loadstep"))
    return StepBefore::last_solution;
  if (!has_previous) return StepBefore::none;
  if (is_solved) return StepBefore::that_of_last_solution;
  if (states.empty())
    refuse(
        "previous= is of a load step before, but not what slipped then, which "
        "kineticfriction= is for: state the contact anew in the variable that "
        "was solved, C = contact(...)");
  return StepBefore::last_solution;
}

void refuse_load_step() {
  refuse(
      "loadstep=true, but the contact was stated anew since its last solution: "
      "state it with previous=");
}

}  // namespace ffcontact::plugin
