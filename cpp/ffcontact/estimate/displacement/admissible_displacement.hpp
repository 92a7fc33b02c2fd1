// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/contact_law.hpp"

namespace ffcontact {

/// u_hat: the displacement with u_n - gap lowered to min(u_n - gap, 0) at the contact
/// nodes, nothing else changed [CHH01, 4.1]. Needed for M'_h only; a displacement that
/// does not penetrate comes back as it is. At a vertex with two nodes, or with a
/// prescribed component, it is the smallest change that keeps all of them; where the
/// vertex cannot move so, the vertices that face it on another body move with it. Where
/// there is no such change, as where prescribed components push a vertex into the
/// foundation, or only one of 1000 times the largest displacement or gap, nothing is
/// changed (see penetration_defect).
/// @param displacement  u_h on all dofs [mm]
/// @param prescribed    1 where the dof is prescribed and stays; empty for none
VectorXd admissible_displacement(const ContactLine& line, const ContactLaw& law,
                                 const Ref<const VectorXd>& displacement,
                                 const Flags& prescribed = {});

/// How far a displacement penetrates: the largest u_n - gap at the nodes, relative to
/// largest_displacement; 0 where it keeps clear. Between the nodes all of it is
/// linear.
struct PenetrationDefect {
  double value = 0;
  int node = 0;  ///< where
};
/// @param least  what it is relative to at least [mm]: of u_hat that of u, whose rounding
///               is all that is left of it where all nodes stick
PenetrationDefect penetration_defect(const ContactLine& line,
                                     const ContactLaw& law,
                                     const Ref<const VectorXd>& displacement,
                                     double least = 0);

}  // namespace ffcontact
