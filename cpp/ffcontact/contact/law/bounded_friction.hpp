// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace ffcontact {

/// Admissible tractions keep to the cone of a coefficient of 1e3 at most, which is inside that
/// of a larger one: what the latter allows beyond it is rounding of P_n. e pays for mu as it
/// is.
constexpr double most_friction = 1e3;
inline double bounded_friction(double mu) {
  return std::min(mu, most_friction);
}

/// Does friction mu cost more where bodies slip than any traction in the cone of
/// most_friction gains? What carries nothing there stays unloaded: what relaxation would
/// make of it is rounding, for which e pays mu times as much.
/// @param slip   |w_t| there [mm]
/// @param moved  the largest displacement [mm]
inline bool outweighs_all_gains(double mu, double slip, double moved) {
  constexpr double far = 10;
  return mu > most_friction && mu * slip > far * most_friction * moved;
}

}  // namespace ffcontact
