// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "ffcontact/contact/condensed/contact_rows.hpp"

namespace ffcontact {

/// What the unknowns v of the primary and q of the dependent rows are divided by: neither
/// units nor the sizes of elements matter then.
struct UnknownScales {
  VectorXd v;  ///< R = diag(S)^-1/2 [f]
  /// 1 / (E_d' R^2 E_d + F_dd)^(1/2): what q_d moves [d]
  VectorXd q;
};
UnknownScales unknown_scales(const CondensedContact& contact);

/// Those that v of the primary and q of the dependent rows make.
ContactRows rows_of(const CondensedContact& contact, const VectorXd& v,
                    const VectorXd& q);

/// The displacement of all dofs that they make, 0 on prescribed ones, under the load of the
/// relation.
/// @param stiffness  that contact was made with
VectorXd displacement_of(const CondensedContact& contact,
                         const CondensedStiffness& stiffness, const VectorXd& v,
                         const VectorXd& P);

/// What v is small against: its largest value, or what the loads would move a node alone,
/// max |g_i| / S_ii with the S_ii of the stiffer component of the node (that of a
/// component in which the body is free is rounding). Where all nodes stick v is nothing
/// but rounding.
double motion_scale(const CondensedContact& contact, const VectorXd& v);

}  // namespace ffcontact
