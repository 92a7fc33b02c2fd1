// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/active_set/active_set.hpp"

namespace ffcontact {

/// The problem without friction, or with Tresca's law, as the convex minimum it is. In
/// the multipliers P of all rows,
///     min  P'C P / 2 + v_0'P    subject to  P_n <= 0,  |P_t| <= b,        v = C P + v_0 its gradient,
/// with the compliance C of the body: S^-1 for the primary rows, S^-1 E between them and
/// the dependent ones, E'S^-1 E + F for these. It is solved face by face
/// (bounded_minimum), which ends whatever the problem is.
///
/// S^-1 need not exist (a body that contact alone holds), nor C be definite (more rows
/// than a vertex has dofs: one displacement, several multipliers). So each pass takes S +
/// r diag(S) and adds r diag(C) to the dependent rows, both acting on the change from the
/// pass before, v - v_k and q - q_k (proximal point method): what the passes converge to,
/// after two or three as a rule, is a solution of the problem itself, one of them where
/// there are several. The face that a pass ends on is also tried as an active set without
/// these terms (solve_active_set), which is the answer if it fulfils the law: C of a body
/// that is hardly held is too large for the passes to be accurate.
///
/// A dependent row that does not load the body has its v given; its multiplier is the
/// bound against v, or 0.
/// @param law  frictionless at every node, or Tresca's
/// @return iterations: Cholesky factorisations of all passes, active sets not counted
ActiveSetResult convex_contact(const CondensedContact& contact,
                               const NodalLaw& law,
                               const NewtonSettings& settings = {});

/// active_set_newton, which needs a few steps as a rule; where it does not converge,
/// convex_contact.
ActiveSetResult solve_convex(const CondensedContact& contact,
                             const NodalLaw& law, ContactStates state,
                             const NewtonSettings& settings = {});

}  // namespace ffcontact
