// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "ffcontact/contact/law/contact_law.hpp"

namespace ffcontact {

/// The constant of Coulomb's law on a surface, where slip has directions and no signs.
///
/// With X = |sigma - sigma_hat|, Y = |u - u_hat|, phi = w_hat_t - w_t and any field s of
/// tangential vectors with |s| <= 1, s . w_hat_t = |w_hat_t|,
///     X^2 + Y^2 <= e^2 + 2 int mu (|r_n| - |r_hat_n|) s . phi + 2 int d . phi,   d = r_hat_t + mu |r_hat_n| s,
/// whatever the exact solution (u, sigma) does. Proof: as in (2.14) [CHH01]
///     X^2 + Y^2 <= e^2 + 2 int (-mu |r_hat_n| |w_hat_t| - r_hat_t . w_t - r_t . w_hat_t + r_t . w_t),
/// where -r_t . w_hat_t <= mu |r_n| |w_hat_t| = mu |r_n| s . w_hat_t by the cone of the
/// exact solution, r_t . w_t = -mu |r_n| |w_t| <= -mu |r_n| s . w_t by its law of slip,
/// and r_hat_t = d - mu |r_hat_n| s leaves -d . w_t = d . phi - d . w_hat_t, the last term
/// of which the cone of r_hat lets be no more than 0.
///
/// s is the direction of w_hat_t where u_hat slips. Where it sticks any s will do:
///     s = -r_hat_t / (mu |r_hat_n|),
/// no longer than 1 by the cone, makes d = 0. Where u_hat slips d is 0 if r_hat is the
/// largest friction against it: d is what the pair misses of the law.
/// (In the plane no assumption on the signs of slip is needed either, if s and d are
/// these.)
///
/// v with v_n = s . phi, v_t = 0 on the surface bounds the term with s . phi as in
/// coulomb_constant, and d is bounded by its dual norm:
///     |int mu (r_n - r_hat_n) s . phi| <= mu kappa X Y,     int d . phi <= delta Y,
///     X^2 + Y^2 <= B^2,   (1 - mu kappa) B^2 = e^2 + 2 delta B    where mu kappa < 1.
struct DirectedSlip {
  /// s, times the slope of the friction bound over mu, the largest coefficient, along t1
  /// and t2 at the nodes [2 x p]
  Matrix2Xd weight;
  Matrix2Xd missed;  ///< int phi_i d along t1, t2 [N, 2 x p]
  Flags left_out;    ///< 1 where phi is 0 [p]
};

struct DirectedConstant {
  double kappa;   ///< of displacements that are condensed, as coulomb_constant
  double missed;  ///< delta on them [the unit of e]
};

/// Infinite where no v of finite energy exists: at a node with a weight whose normal dof
/// is prescribed, or where two sheets meet at an edge; and where a motion without energy
/// changes s . phi.
/// @param contact  of surface_contact
DirectedConstant directed_constant(const CondensedContact& contact,
                                   const DirectedSlip& slip);

/// The condensed relation of a surface.
CondensedContact surface_contact(const ContactSurface& surface,
                                 const ContactLaw<3>& law,
                                 const ElasticSystem& system,
                                 const CondensedStiffness& stiffness);

}  // namespace ffcontact
