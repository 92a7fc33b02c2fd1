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

}  // namespace ffcontact
