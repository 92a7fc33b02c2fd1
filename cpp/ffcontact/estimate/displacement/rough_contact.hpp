// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace ffcontact {

/// Where u_hat is made to stick (sticking_displacement).

/// Components of a direction below this are rounding.
constexpr double no_component = 1e-9;

/// Is friction's bound c more than twice the pressure?
inline bool is_rough(double bound, double pressure) {
  return bound > 2 * pressure;
}

/// The slip below which |C| w_t^2 is less than a tenth of 2 c |w_t| l, and w_t less than 3 times
/// the strain |r| / |C| over the length l [mm]. A larger slip, as beside a corner that cuts a
/// short part off an edge, would cost too much: it is left, and the edge carries nothing
/// (carrying_edges).
/// @param traction   largest |r| on the edge [MPa]
/// @param stiffness  |C| [MPa]
inline double slip_worth_sticking(double bound, double traction, double length,
                                  double stiffness) {
  constexpr double cheap = 0.1, most_strains = 3;
  return std::min(2 * cheap * bound, most_strains * traction) * length /
         stiffness;
}

/// Is friction at its bound, and more than the rounding of the largest traction? (An open node
/// whose pressures are rounding, (-p, mu p), does not slip.)
inline bool slips(double bound, double friction, double largest) {
  constexpr double at_the_bound = 1e-6, rounding = 1e-12;
  return friction > rounding * largest &&
         friction >= (1 - at_the_bound) * bound;
}

}  // namespace ffcontact
