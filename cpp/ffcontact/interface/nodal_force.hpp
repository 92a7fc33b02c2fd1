// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// Adds a force at a contact node, and the opposite one on what it faces [N/mm].
/// @param forces  on all dofs
void add_nodal_force(const ContactLine& line, int node, const Vector2d& force,
                     VectorXd& forces);

/// Nodal forces (F_n, F_t) as a load on all dofs [N/mm].
VectorXd nodal_load(const ContactLine& line, const Ref<const Matrix2Xd>& force,
                    Index dofs);

}  // namespace ffcontact
