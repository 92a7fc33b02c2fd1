// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/uniqueness/coulomb_constant.hpp"
#include "ffcontact/estimate/solid_coulomb.hpp"
#include "support/solid_estimates.hpp"

/// What the bound with Coulomb's law is for a solution.
namespace ffcontact::test {

inline SolidCoulomb coulomb_of(const SolidProblem& problem,
                               const ContactSolution<3>& solution,
                               const Estimate<3>& estimate,
                               StuckNodes stuck = StuckNodes::may_slip) {
  std::vector<char> held(solution.state.size(), 0);
  for (std::size_t i = 0; i < held.size(); ++i)
    held[i] =
        stuck == StuckNodes::stick && solution.state[i] == ContactState::stick;
  return solid_coulomb(topology_of(problem.mesh), problem.surface,
                       problem.system(), solved_solid(problem, solution),
                       estimate, held);
}

}  // namespace ffcontact::test
