// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "ffcontact/contact/contact_settings.hpp"
#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/contact/law/gaps_in_reach.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

/// Is every node open on which a gap was cut to `most`?
inline bool are_open(const ContactStates& state, const VectorXd& gap,
                     double most) {
  for (Index i = 0; i < gap.size(); ++i)
    if (gap[i] > most && state[i] != ContactState::open) return false;
  return true;
}

/// The solution of a law some gaps of which may be far (has_far_gaps). These are cut, and the
/// problem is solved again: where these nodes are open it is the same problem. As
/// displacements may have been wrong this is done until gaps are in proportion. Not of
/// pressures, whose law is that of means over several nodes.
/// @param solve  solve(law, settings)
template <int d, class Solve>
ContactSolution<d> solved_with_far_gaps(const ContactLaw<d>& law,
                                        const ContactSettings& settings,
                                        Solve solve) {
  constexpr int most_cuts = 4;
  ContactSolution<d> found = solve(law, settings);
  if constexpr (d == 2)
    if (law.multiplier != Multiplier::force) return found;
  ContactLaw<d> solved = law;
  for (int k = 0; k < most_cuts; ++k) {
    const double moved = max_norm(found.displacement);
    if (!has_far_gaps(solved, moved)) break;
    const double most = out_of_reach(moved);
    solved = with_gaps_up_to(law, most);
    ContactSettings next = settings;
    next.stiffness = found.stiffness;
    ContactSolution<d> cut = solve(solved, next);
    cut.iterations += found.iterations;
    if (!cut.accepted(settings) || !are_open(cut.state, law.gap, most)) break;
    found = std::move(cut);
  }
  return found;
}

}  // namespace ffcontact
