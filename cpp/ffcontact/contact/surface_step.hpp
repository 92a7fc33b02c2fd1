// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/refined_solver.hpp"
#include "ffcontact/contact/singular_system.hpp"
#include "ffcontact/contact/surface_equations.hpp"

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

}  // namespace ffcontact
