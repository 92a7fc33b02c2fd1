// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/contact_law.hpp"

namespace ffcontact {

/// Projection of multipliers on M_h(-mu g), the step of an Uzawa or fixed-point loop that
/// knows of contact [CHH01, 3.1]:
///     P_n := min(P_n, 0),    P_t := the nearest of [-b, b],
/// node by node for the multipliers P of the law: nodal pressures p for M'_h, nodal
/// forces F_i = len_i p_i for M''_h. In these unknowns the projection is orthogonal; it
/// is not the one of L2. The bound is b = -mu g_n, or Tresca's; without g it is b = -mu
/// P_n after projection, so that the loop ends in Coulomb's law rather than in the
/// problem P(g).
struct MultiplierProjection {
  Matrix2Xd pressure;  ///< projected (p_n, p_t) at the nodes [2 x p]
  int outside = 0;     ///< nodes whose multiplier was changed
};

/// @param pressure        (p_n, p_t) at the nodes [MPa, 2 x p]
/// @param given_pressure  g_n at the nodes [MPa, p], or empty
/// @throws std::invalid_argument  if sizes differ from the line's or a value is not
///                                finite
MultiplierProjection projected_multipliers(
    const ContactLine& line, const ContactLaw<2>& law,
    const Ref<const Matrix2Xd>& pressure,
    const Ref<const VectorXd>& given_pressure = VectorXd());

}  // namespace ffcontact
