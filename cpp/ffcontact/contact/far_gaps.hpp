// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "ffcontact/contact/contact_settings.hpp"
#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

/// Gaps of at most this.
template <int d>
ContactLaw<d> with_gaps_up_to(ContactLaw<d> law, double most) {
  law.gap = law.gap.cwiseMin(most);
  return law;
}

/// Is every node open on which a gap was cut to `most`?
inline bool are_open(const ContactStates& state, const VectorXd& gap,
                     double most) {
  for (Index i = 0; i < gap.size(); ++i)
    if (gap[i] > most && state[i] != ContactState::open) return false;
  return true;
}

/// The solution of a law some gaps of which may be so large that their rounding is no longer
/// small beside the displacements, as where a script means "never" by 1e30. Gaps above 1e6
/// times the largest displacement are cut to 1e3 times it, and the problem is solved again:
/// where these nodes are open it is the same problem. As displacements may have been
/// wrong this is done until gaps are in proportion. Not of pressures, whose law is that of
/// means over several nodes.
/// @param solve  solve(law, settings)
template <int d, class Solve>
ContactSolution<d> solved_with_far_gaps(const ContactLaw<d>& law,
                                        const ContactSettings& settings,
                                        Solve solve) {
  constexpr double far = 1e6, near = 1e3;
  constexpr int most_cuts = 4;
  ContactSolution<d> found = solve(law, settings);
  if (law.gap.size() == 0) return found;
  if constexpr (d == 2)
    if (law.multiplier != Multiplier::force) return found;
  double largest = law.gap.maxCoeff();
  for (int k = 0; k < most_cuts; ++k) {
    const double moved = max_norm(found.displacement), most = near * moved;
    if (!(moved > 0) || !(largest > far * moved)) break;
    ContactSettings next = settings;
    next.stiffness = found.stiffness;
    ContactSolution<d> cut = solve(with_gaps_up_to(law, most), next);
    cut.iterations += found.iterations;
    if (!cut.accepted(settings) || !are_open(cut.state, law.gap, most)) break;
    found = std::move(cut);
    largest = most;
  }
  return found;
}

}  // namespace ffcontact
