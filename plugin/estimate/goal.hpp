// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/bounds/quantity.hpp"
//
#include "problem/plane_bodies.hpp"

namespace ffcontact::plugin {

/// Reads the quantity of interest l of all bodies: goaltraction= w, goalbodyforce= p,
/// goalstress= q and goalconstant=.
/// @param hooke  of all cells
/// @throws std::invalid_argument  if w is not linear on an edge, or p or q in a triangle
Quantity<2> read_goal(Stack stack, const NamedArguments& named,
                      const PlaneBodies& bodies, const Hooke& hooke);

/// @throws std::invalid_argument  if traction= of a body is not linear on an edge: stresses
///                                are not in equilibrium with it then
void require_linear_tractions(Stack stack, const NamedArguments& named,
                              const PlaneBodies& bodies);

/// @param given  l of the hat functions as the script has assembled it [dofs]
/// @throws std::invalid_argument  naming the vertex where it is not that of the quantity
void require_goal(const PlaneBodies& bodies, const Quantity<2>& goal,
                  const VectorXd& given);

}  // namespace ffcontact::plugin
