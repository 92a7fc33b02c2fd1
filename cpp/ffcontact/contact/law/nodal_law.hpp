// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/contact/law/held_rows.hpp"

namespace ffcontact {

/// The law at each node in the units of the multipliers P.
struct NodalLaw {
  std::vector<FrictionCone> cone;  ///< [p]

  int node_count() const { return static_cast<int>(cone.size()); }
  /// Frictionless everywhere, or Tresca's: the solution is the minimum of a convex
  /// function.
  bool is_convex() const;
  /// Does every node hang on what it faces? The conditions are linear then.
  bool is_bonded() const;
};

/// Tresca's law of the problem P(g) [CHH01, (3.1)]: the bound of Coulomb's law at given
/// normal multipliers.
/// @param normal  g_n in units of P [p]; what is above 0 counts as 0
NodalLaw with_given_slip_limit(const NodalLaw& law,
                               const Ref<const VectorXd>& normal);

/// The law with s b, s >= 0, in place of its bound b on friction.
NodalLaw with_share_of_bound(const NodalLaw& law, double s);

/// What violations of the law are relative to.
struct LawScales {
  double v = 0, P = 0;
};

/// The violation where one of two must be 0: the smaller one.
inline double either_violation(double P, double v) {
  return std::min(std::abs(P), std::abs(v));
}

/// Largest violation of the law, (3.17)-(3.22) of plane bodies, by P and v of rows d i + c
/// [d p]: displacements relative to scales.v, multipliers to the largest of them, to
/// scales.P where they are but rounding beside it, or where all are 0 to the largest given
/// bound, which would be nothing beside them. Where one of two must be 0 (P_n or v_n,
/// v_t or P_t + b v_t / |v_t|) the smaller one is the violation: a product would let both be
/// a hundred thousand roundings.
/// @param idle  1 where the friction of a node does nothing to a body, and is not looked at
///              [p]; none: nowhere
double law_violation(const NodalLaw& law, const Ref<const VectorXd>& P,
                     const Ref<const VectorXd>& v, const LawScales& scales,
                     const Flags& idle = {});

/// Puts multipliers that miss the law by rounding exactly into it: P_n <= 0, |P_t| <= b,
/// and P_t = -s b where a node slips.
void put_into_law(const NodalLaw& law, const ContactStates& state, VectorXd& P);

}  // namespace ffcontact
