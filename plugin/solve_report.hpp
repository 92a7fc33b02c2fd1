// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "contact_type.hpp"
#include "ffcontact/contact/contact_solution.hpp"

/// What contactsolve says of a solution, and of its failure.
namespace ffcontact::plugin {

/// Contact nodes by their states.
struct Counts {
  long open = 0, stick = 0, slip = 0;
};
Counts counted(const std::vector<ContactState>& states);

/// Refuses a solution that was not accepted, with what the script can do about it.
[[noreturn]] void refuse_solution(const ContactProblem& problem,
                                  const ElasticSystem& system,
                                  const ContactSolution& solution);

/// @param level  verbosity: one line at 1, details above
void report_solution(long level, const ContactProblem& problem,
                     const ContactSolution& solution, double seconds);

/// Says that a second solution is near or may exist (critical_friction).
void report_friction(long level, const ContactProblem& problem,
                     const SolvedContact& solved);

}  // namespace ffcontact::plugin
