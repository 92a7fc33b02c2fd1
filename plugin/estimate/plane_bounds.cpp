// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/bounds_of.hpp"
#include "estimate/judged.hpp"

namespace ffcontact::plugin {

double plane_bounds(const BoundsCall& call, const Contact& contact) {
  const ContactProblem& problem = plane_problem(contact);
  const Judged judged = judged_of(solved_contact(contact));
  return bounds_of<2>(call, call.settings(8, 1), problem, problem.topology(),
                      problem.line, *judged.system, judged.body);
}

}  // namespace ffcontact::plugin
