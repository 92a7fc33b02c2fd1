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
VectorXd admissible_displacement(const ContactLine& line,
                                 const ContactLaw<2>& law,
                                 const Ref<const VectorXd>& displacement,
                                 const Flags& prescribed = {});

/// u_hat that keeps clear between the nodes, too, where directions turn along an edge: with
/// q = w_n - gap <= 0 at its nodes i, j and the middle coefficient m of w . n(s) - gap
/// (EdgeMotions) it does if and only if m <= (q_i q_j)^(1/2). Where it does not both nodes
/// are lowered by m / (1 + n_i . n_j) along their normals, and as often as needed where
/// supports hold one of them. Nothing else changes.
/// @param displacement  clear at the nodes [mm]
VectorXd cleared_between_nodes(const ContactLine& line,
                               const ContactLaw<2>& law,
                               const Ref<const VectorXd>& displacement,
                               const Flags& prescribed = {});

/// Where u_n - gap is the largest along the line, and by how much it is above 0; the node
/// that is next to it. Of bonded bodies, the node where they are the farthest apart.
DeepestNode deepest_node(const ContactLine& line, const ContactLaw<2>& law,
                         const Ref<const VectorXd>& displacement);

}  // namespace ffcontact
