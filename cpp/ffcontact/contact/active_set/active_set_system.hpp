// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/active_set/singular_system.hpp"
#include "ffcontact/contact/condensed/condensed_rows.hpp"
#include "ffcontact/contact/law/nodal_law.hpp"

namespace ffcontact {

/// With the state of every node known, all conditions are linear:
///     open:  P_n = 0, P_t = 0        closed:  v_n = 0
///     stick: v_t = 0                 slip s:  P_t = s mu P_n  (Tresca: P_t = -s b, open or not; at the shear limit P_t = -s k),
///                                             s = sign of v_t
/// together with P = S v - g - E q of the body. Unknown are v of the primary rows that
/// are not given and q; rows and columns are scaled by the diagonal of S, so that neither
/// units nor the sizes of the elements matter. A dependent row that the unknowns do not
/// move has its multiplier continued (CondensedContact::continued), or 0 if it does not
/// load the body either, as nodal forces on prescribed dofs.
/// @param state  of each node [p]
/// @param rows   the answer; not touched if the system is not finite
SystemKind solve_active_set(const CondensedContact& contact,
                            const NodalLaw& law, const ContactStates& state,
                            ContactRows& rows);

/// The scaled matrix of that system; affine in the coefficients of friction.
MatrixXd active_set_matrix(const CondensedContact& contact, const NodalLaw& law,
                           const ContactStates& state);

}  // namespace ffcontact
