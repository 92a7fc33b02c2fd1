// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/condensed_stiffness.hpp"
#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// u* - u_h where K u* = b + (nodal forces of r_hat) and K u_h = b + (nodal forces of
/// lambda_h): the displacement whose stresses are in equilibrium with r_hat.
///
/// Where K is singular (rigid motions Z that contact alone holds) the change of forces
/// does no work on Z, and the solution without rigid motion on the contact dofs is taken:
/// S + Z_c Z_c' in place of S. Cost: one factorisation. The same balances any other small
/// change of the nodal forces, as the rounding of u_h leaves.
/// @param force_change  on all dofs [N/mm]
/// @param motions       free_rigid_motions of the body [dofs x k]
/// @throws std::runtime_error  if a part of the body is held by nothing
VectorXd rebalancing_displacement(const ElasticSystem& system, const ContactLine& line,
                                  const VectorXd& force_change, const MatrixXd& motions);

/// The same with the factor at hand: one back-substitution.
/// @param stiffness  K condensed to contact_dofs(line, system)
VectorXd rebalancing_displacement(const CondensedStiffness& stiffness,
                                  const ElasticSystem& system, const ContactLine& line,
                                  const VectorXd& force_change, const MatrixXd& motions);

}  // namespace ffcontact
