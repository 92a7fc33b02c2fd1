// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/active_set/singular_system.hpp"
#include "ffcontact/contact/newton/inexact_step.hpp"
#include "ffcontact/linear/refined_solver.hpp"

namespace ffcontact {

/// How the steps of surface_newton are solved; what one leaves serves the next ones.
class StepSolver {
 public:
  /// To rounding (solve_surface_step).
  StepSolver() = default;
  /// By InexactStep, and to rounding where that cannot be.
  /// @param held  of surface_trace [3 p]
  StepSolver(const CondensedContact& contact, const Flags& held);

  /// @param rows  the last ones, then the next
  SystemKind solve(const CondensedContact& contact,
                   const SurfaceEquations& equations, ContactRows& rows);

 private:
  std::optional<InexactStep> inexact_;
  RefinedSolver exact_;
};

}  // namespace ffcontact
