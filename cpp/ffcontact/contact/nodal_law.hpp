// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/contact_law.hpp"

namespace ffcontact {

/// The law at each node in the units of the multipliers P.
struct NodalLaw {
  VectorXd friction;      ///< mu [p]
  VectorXd tresca_bound;  ///< in units of P [p]; empty for Coulomb
  VectorXd shear_limit;   ///< of Coulomb's law in units of P [p]; empty for none

  bool tresca() const { return tresca_bound.size() > 0; }
  double limit(int node) const {
    return shear_limit.size() > 0 ? shear_limit[node]
                                  : std::numeric_limits<double>::infinity();
  }
  double bound(int node, double normal_multiplier) const {
    if (tresca()) return tresca_bound[node];
    return std::min(friction[node] * std::max(0.0, -normal_multiplier), limit(node));
  }
  /// Frictionless everywhere, or Tresca's: the solution is the minimum of a convex
  /// function.
  bool is_convex() const { return tresca() || friction.isZero(0); }
  bool frictionless(int node) const {
    return tresca() ? tresca_bound[node] == 0 : friction[node] == 0 || limit(node) == 0;
  }
};

NodalLaw nodal_law(const ContactLaw& law, const ContactLine& line);

/// Tresca's law of the problem P(g) [CHH01, (3.1)]: the bound of Coulomb's law at given
/// normal multipliers.
/// @param normal  g_n in units of P [p]; what is above 0 counts as 0
NodalLaw with_given_slip_limit(const NodalLaw& law, const Ref<const VectorXd>& normal);

/// Largest violation of (3.17)-(3.22) by P and v, rows 2 i + c [2 p]: displacements
/// relative to scales.v, multipliers to the largest of them, or to scales.P where they
/// are but rounding beside it. Where one of two must be 0 (P_n or v_n, the distance to
/// the bound or v_t, P_t or v_t if they have one sign) the smaller one is the violation:
/// a product would let both be a hundred thousand roundings.
double law_violation(const NodalLaw& law, const Ref<const VectorXd>& P,
                     const Ref<const VectorXd>& v, const LawScales& scales);

/// Puts multipliers that miss the law by rounding exactly into it: P_n <= 0, |P_t| <= b,
/// and P_t = -s b where a node slips.
void put_into_law(const NodalLaw& law, const std::vector<ContactState>& state,
                  VectorXd& P);

}  // namespace ffcontact
