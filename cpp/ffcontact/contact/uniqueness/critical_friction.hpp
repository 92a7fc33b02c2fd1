// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/active_set/active_set_system.hpp"

namespace ffcontact {

/// The smallest coefficient of friction at which the linearised problem of a state (open,
/// stick, slip with its signs) is singular: there a second solution may branch off.
///
/// With open nodes free and sticking ones held, P_t = s mu P_n and v_n = 0 on the slipping
/// nodes leave
///     (C_NN + mu C_NT s) P_n = 0,   v = C P the compliance of the slipping nodes,
/// the pencil in which mu is sought; v = 0 elsewhere. The system of solve_active_set is
/// that pencil with all rows, A(mu) = A_0 + mu A_1, and 1/mu is the largest real
/// eigenvalue of -A_0^-1 A_1. Where the body is not held without friction, A_0 singular,
/// the same is done from mu = -1.
///
/// Nodes that slip at the shear limit, by their P_n, slip whatever mu. Where the coefficient varies, all are multiplied by one factor, and the largest is
/// returned; mu = 0 everywhere counts as one coefficient. Infinite if there is none: no
/// node slips, or not with Coulomb's law. 0 if the system is singular for every mu.
/// @param P  of the solution, rows 2 i + c [2 p]
double critical_friction(const CondensedContact& contact, const NodalLaw& law,
                         ContactStates state, const Ref<const VectorXd>& P);

}  // namespace ffcontact
