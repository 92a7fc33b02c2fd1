// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/bounds_of.hpp"
#include "estimate/solid_error.hpp"
#include "problem/result_names.hpp"

namespace ffcontact::plugin {

double solid_bounds(const BoundsCall& call, const SolidContact& contact) {
  if (!contact.solved) refuse_unsolved();
  const ContactProblem<3>& problem = *contact.problem;
  return bounds_of<3>(call, call.settings(4, steps_of_a_sweep), problem,
                      topology_of(problem.mesh, problem.facets),
                      problem.contact, *contact.solved->system,
                      judged_body(*contact.solved));
}

}  // namespace ffcontact::plugin
