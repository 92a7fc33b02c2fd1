// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/uniqueness/coulomb_constant.hpp"
#include "ffcontact/contact/uniqueness/critical_friction.hpp"
#include "support/condensed.hpp"

/// What a solution says of the bound and the uniqueness with Coulomb's law.
namespace ffcontact::test {

inline Matrix2Xd multipliers(const Problem& problem,
                             const ContactSolution<2>& solution) {
  return problem.law.multiplier == Multiplier::force ? solution.force
                                                     : solution.pressure;
}

inline SlipPattern slip_pattern_of(const Problem& problem,
                                   const ContactSolution<2>& solution) {
  const Matrix2Xd w = displacement_against_foundation(problem.line, problem.law,
                                                      solution.displacement);
  return slip_pattern(nodal_law(problem.law, problem.line),
                      multipliers(problem, solution), solution.force, w.row(1));
}

inline double kappa_of(Problem problem, const ContactSolution<2>& solution,
                       StuckNodes stuck = StuckNodes::may_slip) {
  const SlipPattern pattern = slip_pattern_of(problem, solution);
  problem.law.multiplier = Multiplier::force;
  const Condensed condensed(problem);
  return coulomb_constant(condensed.contact, pattern,
                          largest_friction(condensed.law), stuck);
}

inline double kappa_of(const Problem& problem) {
  return kappa_of(problem, solved(problem));
}

inline double critical_friction_of(const Problem& problem,
                                   const ContactSolution<2>& solution) {
  const Condensed condensed(problem);
  return critical_friction(condensed.contact, condensed.law, solution.state,
                           multipliers(problem, solution).reshaped());
}

}  // namespace ffcontact::test
