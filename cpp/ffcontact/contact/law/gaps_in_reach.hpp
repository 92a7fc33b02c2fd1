// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/mesh/mesh.hpp"

/// Gaps so large that they never close, as where a script means "never" by 1e30: their
/// rounding, or that of what multiplies them, is not small beside the displacements. Cut to
/// what nothing reaches they state the same problem.
namespace ffcontact {

/// Gaps of at most this.
template <int d>
ContactLaw<d> with_gaps_up_to(ContactLaw<d> law, double most) {
  law.gap = law.gap.cwiseMin(most);
  return law;
}

/// Is a gap 1e6 times as large as the largest displacement?
template <int d>
bool has_far_gaps(const ContactLaw<d>& law, double moved) {
  constexpr double far = 1e6;
  return law.gap.size() > 0 && moved > 0 && law.gap.maxCoeff() > far * moved;
}

/// What far gaps are cut to [mm].
constexpr double out_of_reach(double moved) { return 1e3 * moved; }

template <int d>
ContactLaw<d> with_gaps_in_reach(const ContactLaw<d>& law, double moved) {
  return has_far_gaps(law, moved) ? with_gaps_up_to(law, out_of_reach(moved))
                                  : law;
}

/// Before anything moves: by the size of the body, or what is prescribed where that is more.
template <int d>
ContactLaw<d> with_gaps_in_reach(const ContactLaw<d>& law,
                                 const SimplexMesh<d>& mesh,
                                 const VectorXd& prescribed) {
  return with_gaps_up_to(law, 10 * std::max(box_sides(mesh.vertices).maxCoeff(),
                                            max_norm(prescribed)));
}

}  // namespace ffcontact
