// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/condensed_contact.hpp"

namespace ffcontact {

/// The law at each node in the units of P and v = W u.
struct NodalLaw {
  Eigen::VectorXd friction;      ///< mu [p]
  Eigen::VectorXd tresca_bound;  ///< in units of P [p]; empty for Coulomb
  Eigen::VectorXd limit;         ///< W gap: v_n <= limit [p]

  double bound(int node, double normal_multiplier) const {
    return tresca_bound.size() > 0 ? tresca_bound[node] : friction[node] * std::max(0.0, -normal_multiplier);
  }
  bool frictionless(int node) const { return tresca_bound.size() > 0 ? tresca_bound[node] == 0 : friction[node] == 0; }
};

NodalLaw nodal_law(const ContactLaw& law, const ContactLine& line);

enum class ContactStatus {
  converged,
  cycled,          ///< the active set came back to an earlier one
  singular,        ///< a motion of the body is left free by the last active set
  not_converged,   ///< iterations used up
};

/// Multipliers and displacements of all rows (2 i + c), the last active set, and how it was reached.
struct ActiveSetResult {
  Eigen::VectorXd P, v;  ///< [2 p]
  std::vector<ContactState> state;
  int iterations = 0;
  ContactStatus status = ContactStatus::not_converged;
};

/// Semismooth Newton on the condensed system: with the state of every node known, all conditions are linear.
///     open:  P_n = 0, P_t = 0          closed:  v_n = limit
///     stick: v_t = 0                   slip s:  P_t = s mu P_n  (Tresca: P_t = -s b),  s = sign of v_t
/// Solve, then change the state of every node that its own answer contradicts: closed and P_n > 0 opens; open and v_n > limit
/// slips along v_t; stick and |P_t| > b slips against P_t; slip and s v_t < 0 sticks. A node never turns from slip to slip directly:
/// that is the primal-dual active set with its augmentation parameter sent to zero, free of scale, and it does not cycle
/// between the two slips. The first set without a contradiction is a solution of Prop. 3.4 / 3.5.
/// @param state  first guess [p]
ActiveSetResult active_set_newton(const CondensedContact& contact, const NodalLaw& law, std::vector<ContactState> state,
                                  int max_iterations);

}  // namespace ffcontact
