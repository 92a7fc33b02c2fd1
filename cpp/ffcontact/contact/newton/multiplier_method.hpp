// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/active_set/active_set.hpp"
#include "ffcontact/contact/condensed/condensed_contact.hpp"

namespace ffcontact {

/// The problem whose bound b on friction is given (none, or Tresca's) as the convex
/// minimum it is, by the method of multipliers [Rockafellar 1976], which ends whatever the
/// problem is. In the components z = (w, w_o) of ContactTrace, with S and g of the bodies
/// and v = A z + v_0:
///     z_k = argmin  z'S z / 2 - g'z + sum |Pi(P_k - c v)|^2 / (2 c) + r |z - z_(k-1)|_D^2 / 2,
///     P_(k+1) = Pi(P_k - c v(z_k)),
/// Pi the projection onto P_n <= 0, |P_t| <= b, D = diag(S). The function is convex and its
/// gradient
///     S z - g - A'Pi(P_k - c v) + r D (z - z_(k-1))
/// has a derivative almost everywhere, S + A'c Pi' A + r D, so that Newton's method with a
/// line search finds its minimum. c is the stiffness of the node and grows from minimum to
/// minimum. r lets bodies be held by contact alone.
/// @param held  rows without force and condition [rows]
/// @return      iterations: Cholesky factorisations
ActiveSetResult multiplier_method(const CondensedContact& contact,
                                  const CondensedStiffness& stiffness,
                                  const NodalLaw& law, const Flags& held,
                                  const NewtonSettings& settings = {});

}  // namespace ffcontact
