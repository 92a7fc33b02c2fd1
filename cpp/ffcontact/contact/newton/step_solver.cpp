// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/step_solver.hpp"

#include <algorithm>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/newton/surface_step.hpp"

namespace ffcontact {

StepSolver::StepSolver(const CondensedContact& contact, const Flags& held) {
  const auto& dependent = contact.dependent;
  if (std::all_of(dependent.begin(), dependent.end(),
                  [&held](int row) { return held[row]; }))
    inexact_.emplace(contact);
}

SystemKind StepSolver::solve(const CondensedContact& contact,
                             const SurfaceEquations& equations,
                             ContactRows& rows) {
  if (inexact_ && inexact_->solve(contact, equations, rows))
    return SystemKind::regular;
  return solve_surface_step(contact, equations, rows, exact_);
}

}  // namespace ffcontact
