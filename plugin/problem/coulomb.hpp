// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/uniqueness/coulomb_constant.hpp"
//
#include "problem/contact_type.hpp"

namespace ffcontact::plugin {

/// Multipliers P and forces W P that belong to a displacement [2 x p].
struct ContactForces {
  Matrix2Xd multiplier, force;
};
ContactForces contact_forces(const ContactLaw<2>& law,
                             const ContactSolution<2>& solution);
/// Of the pressures that a script gives.
ContactForces contact_forces(const ContactLine& line, const ContactLaw<2>& law,
                             const Matrix2Xd& given);

/// Reads stick=: "free" (default) or "held".
/// @throws std::invalid_argument  if it is neither
StuckNodes stuck_nodes_of(Stack stack, const NamedArguments& named);
const char* stuck_in_words(StuckNodes stuck);

/// kappa for the slip of a displacement and the largest coefficient that goes with it.
struct CoulombConstant {
  double kappa;
  double friction;  ///< mu, also between the nodes
};
/// @param contact  of Multiplier::force
CoulombConstant coulomb_constant_of(const ContactLine& line,
                                    const ContactLaw<2>& law,
                                    const CondensedContact& contact,
                                    const VectorXd& displacement,
                                    const ContactForces& forces,
                                    StuckNodes stuck);

/// The condensed relation of Multiplier::force, without another factorisation.
/// @param solved  that of `law`, if there is one
std::shared_ptr<const CondensedContact> contact_of_forces(
    const ContactLine& line, ContactLaw<2> law, const ElasticSystem& system,
    const CondensedStiffness& stiffness,
    const std::shared_ptr<const CondensedContact>& solved);

/// critical_friction of the solution.
double critical_friction_of(const ContactProblem<2>& problem,
                            const SolvedContact<2>& solved);

}  // namespace ffcontact::plugin
