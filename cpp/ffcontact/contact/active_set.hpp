// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/active_set_system.hpp"

namespace ffcontact {

enum class ContactStatus {
  converged,
  cycled,         ///< the active set came back to an earlier one
  singular,       ///< a motion of the body is left free by the last active set
  not_converged,  ///< iterations used up
  inaccurate,     ///< the active set is settled, but violation or residual exceed the tolerance
};

/// The answer with the smallest violation, its active set, and how it was reached.
struct ActiveSetResult {
  Eigen::VectorXd P, v;             ///< multipliers and displacements of all rows 2 i + c [2 p]
  std::vector<ContactState> state;  ///< [p]
  double violation = 0;             ///< law_violation of P and v, relative to the largest v
  int iterations = 0;
  ContactStatus status = ContactStatus::not_converged;
};

struct NewtonSettings {
  int max_iterations = 200;
  double tolerance = 1e-10;  ///< where rounding keeps the active set from settling: violation that is accepted
};

/// Semismooth Newton on the condensed system: solve for the active set (solve_active_set), then change the state of every node
/// that its own answer contradicts: closed and P_n > 0 opens; open and v_n > 0 slips along v_t; stick and |P_t| > b slips against
/// P_t; slip s and s v_t < 0 sticks; a closed or sticking node that a prescribed dof moves away opens or slips. With Tresca's
/// law, whose friction does not ask for contact, the two components of a node change independently. A node never
/// turns from slip to slip directly: that is the primal-dual active set with its augmentation parameter sent to zero, free of
/// scale, and it does not cycle between the two slips. The first set without a contradiction is a solution of Prop. 3.4 / 3.5.
///
/// Safeguard (block principal pivoting, Judice and Pires, Comput. Oper. Res. 21, 1994): when ten steps have not lowered the number
/// of contradictions, only the last contradicted node changes until they are fewer. For Tresca's law and without friction, where
/// S is positive definite, this ends; with Coulomb's law it need not, and the run stops as cycled when it comes back to a set that
/// it has tried or after twenty such steps in vain.
/// @param state  first guess [p]
ActiveSetResult active_set_newton(const CondensedContact& contact, const NodalLaw& law, std::vector<ContactState> state,
                                  const NewtonSettings& settings = {});

}  // namespace ffcontact
