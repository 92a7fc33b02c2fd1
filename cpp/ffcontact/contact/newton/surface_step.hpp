// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/contact/active_set/singular_system.hpp"
#include "ffcontact/contact/newton/surface_equations.hpp"
#include "ffcontact/linear/refined_solver.hpp"

namespace ffcontact {

/// The next P and v of all rows 3 i + c by the equations of their nodes' states
/// (surface_newton). Unknown are v of the primary rows without the condition v = 0 and P
/// of the dependent rows that are not held. These have a proximal term r (P - last P): at
/// nodes of one vertex forces may be shared in more than one way, and stay as they are.
/// @param rows    the last ones, then the next; unchanged if the system is not finite
/// @param solver  of the steps before
SystemKind solve_surface_step(const CondensedContact& contact,
                              const SurfaceEquations& equations,
                              ContactRows& rows, RefinedSolver& solver);

/// The next P and v where the bounds rho change: at + s along.
struct StepLine {
  ContactRows at, along;
  /// Sign of the determinant of the natural map's derivative by v and the dependent P.
  int orientation = 1;
};

/// By one factorisation; nothing where the system is singular.
/// @param last          the last rows
/// @param bound_change  of rho, at s = 1 [p]
std::optional<StepLine> surface_step_line(const CondensedContact& contact,
                                          const SurfaceEquations& equations,
                                          const ContactRows& last,
                                          const VectorXd& bound_change);

}  // namespace ffcontact
