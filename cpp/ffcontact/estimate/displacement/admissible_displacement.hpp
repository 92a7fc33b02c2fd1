// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/estimate/error/deepest_node.hpp"

namespace ffcontact {

/// u_hat: the displacement with u_n - gap lowered to min(u_n - gap, 0) at the contact
/// nodes, nothing else changed [CHH01, 4.1]. Needed for M'_h only; a displacement that
/// does not penetrate comes back as it is. At a vertex with two nodes, or with a
/// prescribed component, it is the smallest change that keeps all of them; where the
/// vertex cannot move so, the vertices that face it on another body move with it. Where
/// there is no such change, as where prescribed components push a vertex into the
/// foundation, or only one of 1000 times the largest displacement or gap, nothing is
/// changed (see deepest_node).
/// @param displacement  u_h on all dofs [mm]
/// @param prescribed    1 where the dof is prescribed and stays; empty for none
VectorXd admissible_displacement(const ContactLine& line, const ContactLaw& law,
                                 const Ref<const VectorXd>& displacement,
                                 const Flags& prescribed = {});

/// Where u_n - gap is the largest, and by how much it is above 0. Between the nodes all of it
/// is linear.
DeepestNode deepest_node(const ContactLine& line, const ContactLaw& law,
                         const Ref<const VectorXd>& displacement);

}  // namespace ffcontact
