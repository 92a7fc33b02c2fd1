// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/progress.hpp"
#include "ffcontact/contact/active_set/active_set_system.hpp"

namespace ffcontact {

enum class ContactStatus {
  converged,
  cycled,         ///< the contradictions of the active set do not get fewer
  singular,       ///< a motion of the body is left free by the last active set
  not_converged,  ///< iterations used up
  /// the active set is settled, but violation or residual exceed the tolerance
  inaccurate,
};

/// The answer with the smallest violation, its active set, and how it was reached.
struct ActiveSetResult {
  VectorXd P, v;  ///< multipliers and displacements of all rows 2 i + c [2 p]
  ContactStates state;   ///< [p]
  double violation = 0;  ///< law_violation of P and v
  int iterations = 0;
  ContactStatus status = ContactStatus::not_converged;

  /// Takes these rows and their active set for the answer.
  void keep(ContactStates active_set, ContactRows rows, double of_law) {
    P = std::move(rows.P);
    v = std::move(rows.v);
    state = std::move(active_set);
    violation = of_law;
  }
  bool is_better_than(const ActiveSetResult& other) const {
    return status == ContactStatus::converged || violation < other.violation;
  }
  /// The better one, with the linear systems of both; a body that slides stays one.
  void add(ActiveSetResult&& next) {
    const int systems = iterations + next.iterations;
    if (next.status == ContactStatus::singular) status = next.status;
    if (next.is_better_than(*this)) *this = std::move(next);
    iterations = systems;
  }
};

struct NewtonSettings {
  int max_iterations = 200;  ///< linear systems in all
  double tolerance = 1e-10;  ///< law_violation that is accepted
  ProgressReport report{};   ///< of every step, with its violation
  /// violation from which on no step is made (surface_newton)
  double enough = 1e-13;

  NewtonSettings with_at_most(int systems) const {
    return {systems, tolerance, report, enough};
  }
};

/// Semismooth Newton on the condensed system: solve for the active set
/// (solve_active_set), then change the state of every node that its own answer
/// contradicts: closed and P_n > 0 opens; open and v_n > 0 slips along v_t; stick and
/// |P_t| > b slips against P_t, at the shear limit where -mu P_n exceeds it; slip s and s
/// v_t < 0 sticks; a closed or sticking node that a prescribed dof moves away opens or
/// slips. With Tresca's law, whose friction does not ask for contact, the two components
/// of a node change independently. A node never turns from slip to slip directly: that is
/// the primal-dual active set with its augmentation parameter sent to zero, free of
/// scale, and it does not cycle between the two slips. The first set without a
/// contradiction is a solution of Prop. 3.4 / 3.5.
///
/// When ten steps have not lowered the number of contradictions the run stops as cycled:
/// solve_convex and fixed_point go on.
///
/// Converged is what fulfils the law to the tolerance: a set without a contradiction may
/// be no solution where rows depend on each other and their multipliers have more than
/// one value.
/// @param state  first guess [p]
ActiveSetResult active_set_newton(const CondensedContact& contact,
                                  const NodalLaw& law, ContactStates state,
                                  const NewtonSettings& settings = {});

/// Displacements are relative to motion_scale and multipliers to 1e-4 of the largest load
/// on the line, g, which counts the gaps and prescribed motions by their stiffness:
/// beside it rounding is rounding.
LawScales law_scales(const CondensedContact& contact, const VectorXd& v);

/// law_violation of an answer, relative to law_scales; infinite where the loads are
/// rounding beside the multipliers (1e-10): forces that friction holds between two nodes
/// of a vertex, whatever they are, answer another problem.
double law_violation(const CondensedContact& contact, const NodalLaw& law,
                     const ContactRows& rows);

}  // namespace ffcontact
