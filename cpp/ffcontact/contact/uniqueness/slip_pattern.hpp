// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/nodal_law.hpp"

namespace ffcontact {

/// The friction of a solution to first order: where a node slips with the sign s,
///     P_t = -s b(P_n),   b = c + mu |P_n| up to the limit k,   db/d|P_n| = slope.
struct SlipPattern {
  /// s = 1 or -1 of each node: opposite to P_t, where it sticks to the force F_t (the P_t
  /// of M'_h may alternate), where there is none the sign of w_t, where there is neither
  /// that of the next node before (or after) [p]
  VectorXd sign;
  VectorXd slope;  ///< mu, or 0 at the shear limit and with Tresca's law [p]
  Flags sticks;    ///< |P_t| < b on a closed node [p]
  bool reaches_limit = false;  ///< is a node at the shear limit?

  /// s slope / mu, mu the largest of the law; 0 where friction does not depend on P_n.
  VectorXd weight(double largest_friction) const;
};

/// Largest mu of the nodes; 0 with Tresca's law.
double largest_friction(const NodalLaw& law);

/// @param multiplier  P_n, P_t [2 x p]; what is within 1e-6 of the bound is at it
/// @param force       F_n, F_t = W P [2 x p]
/// @param slip        w_t of u_hat, less that of the load step before [p]
SlipPattern slip_pattern(const NodalLaw& law,
                         const Ref<const Matrix2Xd>& multiplier,
                         const Ref<const Matrix2Xd>& force,
                         const Ref<const VectorXd>& slip);

}  // namespace ffcontact
