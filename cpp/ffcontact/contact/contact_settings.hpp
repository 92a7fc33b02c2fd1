// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ffcontact/base/progress.hpp"
#include "ffcontact/contact/condensed/contact_rows.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "ffcontact/elastic/multigrid/multigrid_inverse.hpp"

namespace ffcontact {

enum class ContactSolver {
  /// active_set_newton; where it does not converge, convex_contact, or fixed_point helped
  /// by Newton
  newton,
  fixed_point,  ///< fixed_point [CHH01, Definition 3.1]
};

/// What solves the linear systems of a solid.
enum class LinearSolver {
  automatic,  ///< multigrid from ContactSettings::multigrid_from on, where it can
  direct,
  multigrid,
};

struct ContactSettings {
  ContactSolver solver = ContactSolver::newton;
  int max_iterations = 2000;  ///< linear systems of the contact line in all
  /// largest complementarity and residual defect of an accepted answer
  double tolerance = 1e-10;
  /// a guess, e.g. of the load step before; empty: every node sticks
  ContactStates initial_state;
  /// the guess is that of nearest nodes of another mesh: solids in single precision have a
  /// better one of their own (coarse_start)
  bool state_of_another_mesh = false;
  /// P and v of the nodes of a problem nearby, e.g. at the nearest nodes of another mesh.
  /// Multigrid starts from them, which say where nodes slip to, before it tries the states
  std::optional<ContactRows> near{};
  std::shared_ptr<const CondensedStiffness>
      stiffness;  ///< of an earlier solution with this K and line; null: factorise
  /// factorises K for kept dofs where it is not done on this machine alone; null: here
  std::function<std::shared_ptr<const CondensedStiffness>(
      const ElasticSystem& system, const std::vector<int>& kept,
      Precision precision)>
      factorise{};
  /// free dofs from which on a solid that prescribed displacements hold is factored in
  /// single precision, and its answer corrected
  int single_precision_from = 30000;
  LinearSolver linear = LinearSolver::automatic;
  /// free dofs from which on solids are solved by multigrid
  /// (multigrid_relation), and by a factor where that does not converge
  int multigrid_from = multigrid_pays_from;
  /// told of the factorisation, its columns and those of Schur's complement, and of every step, with its violation
  ProgressReport report{};

  ContactStates first_states(int nodes) const {
    return initial_state.empty() ? all_stick(nodes) : initial_state;
  }
};

/// @throws std::invalid_argument  if maxit is not positive, or the initial states are not
///                                those of so many nodes
void require_valid(const ContactSettings& settings, int nodes);

}  // namespace ffcontact
