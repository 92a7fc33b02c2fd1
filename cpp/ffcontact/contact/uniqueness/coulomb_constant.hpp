// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "ffcontact/contact/uniqueness/slip_pattern.hpp"

namespace ffcontact {

/// Of the nodes where u_hat sticks, in the exact solution.
enum class StuckNodes {
  may_slip,  ///< with the sign that P_t says
  stick,  ///< |w_t| - |w_hat_t| = 0 there; and the shear limit is reached where it is
};

/// The constant of Coulomb's law [CHH01, Remark 2.6] on the space of displacements that is
/// condensed:
///     |2 mu int (r_n - r_hat_n)(|w_hat_t| - |w_t|)| <= 2 mu kappa |sigma - sigma_hat| |u - u_hat|,
///     |sigma - sigma_hat|^2 + |u - u_hat|^2 <= e^2 / (1 - mu kappa).
/// Where w_t and w_hat_t have the sign s, |w_hat_t| - |w_t| = s phi with phi = w_hat_t -
/// w_t. For v with v_n = s phi, v_t = 0 on the line int (r_n - r_hat_n) s phi = int (sigma -
/// sigma_hat) : eps(v), and |u - u_hat|^2 is at least the energy of phi with u_n left free:
///     kappa^2 = max over phi of (m phi)' S_nn (m phi) / phi' (S_tt - S_tn S_nn^-1 S_nt) phi,
/// with m = s where mu is the same all along, and generally s / mu times the slope of the
/// friction bound (SlipPattern::weight), mu the largest coefficient (SlipForms).
///
/// Infinite where no v of finite energy exists: at a slipping node whose normal dof is
/// prescribed, or at a corner of the line (two nodes on one vertex); and where a motion
/// without energy changes phi, but not with the sign s. Infinite, too, where a node is at
/// the shear limit, unless it is there in the exact solution (StuckNodes::stick): the
/// slope of the bound between two solutions is not known then.
/// 0 if friction does not depend on r_n: Tresca's law, mu = 0.
/// @param contact  of Multiplier::force: v are the components of the displacement
/// @param largest_friction  mu
double coulomb_constant(const CondensedContact& contact,
                        const SlipPattern& pattern, double largest_friction,
                        StuckNodes stuck);

/// The B of (1 - mu kappa) B^2 = e^2 + 2 missed B: e / sqrt(1 - mu kappa) where nothing is
/// missed; infinite where mu kappa >= 1.
/// @param missed  the dual norm of directed_constant, 0 where slip has one sign [the unit
///                of e]
double coulomb_bound(double e, double largest_friction, double kappa,
                     double missed = 0);

}  // namespace ffcontact
