// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// An admissible pair obeys the law at every point of the contact boundary, not at nodes
/// alone. Then the integrand of the contact part of e^2,
///     f = c(r_n) |w_t| + r_t . w_t + r_n (w_n - gap),        [CHH01, (2.11), (2.19)]
/// is nowhere negative: |r_t| <= c, r_n <= 0 and w_n <= gap. Where the contact directions
/// of a facet's nodes are the same it follows from its nodes, as r_hat and w_hat are linear
/// between them. Where they differ r_hat turns with them (moments_of_ends, BentTraction), as
/// long as that is by less than 90 degrees.
struct BetweenNodes {
  /// largest -f, of some points of each facet [MPa mm], and the facet that has it
  double negative = 0;
  int negative_facet = 0;
  /// largest angle between the directions of two nodes of a facet that carries tractions or
  /// that u_hat penetrates [rad], if it is 90 degrees or more, and that facet
  double turn = 0;
  int turned_facet = 0;

  void note_integrand(double f, int facet) {
    if (-f <= negative) return;
    negative = -f;
    negative_facet = facet;
  }
  void note_turn(double angle, int facet) {
    if (angle <= turn) return;
    turn = angle;
    turned_facet = facet;
  }
};

/// |w_t| below this is rounding and counts as 0, as e would pay c times it for any c: a u_hat
/// that differs by rounding has w_t = 0 [mm].
template <class Law>
double rounding_of_slip(const Law& law, const Ref<const VectorXd>& u_hat) {
  constexpr double part = 1e-13;
  return part * largest_displacement(law, u_hat);
}
inline double slip_beyond(double least, double slip) {
  return std::abs(slip) > least ? slip : 0;
}

}  // namespace ffcontact
