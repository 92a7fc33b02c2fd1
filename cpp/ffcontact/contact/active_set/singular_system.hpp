// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/linear/refined_solver.hpp"

namespace ffcontact {

/// Reciprocal condition number below which a scaled system counts as singular.
inline constexpr double singular_condition = 1e-13;

/// How the linear system of an active set was solved.
enum class SystemKind {
  regular,
  /// singular, but the loads do not work on the motion that is left free: the smallest
  /// solution
  consistent,
  /// the loads push along a motion that the active set leaves free: the body is let go a
  /// long way along it
  inconsistent,
};

/// x of A x = b, rows and columns scaled.
/// @param transposed     A': equations are assembled as columns
/// @param displacements  how many of the unknowns are; they come first
/// @param kind           how it was solved
/// @param solver         of the systems before
VectorXd solved(const MatrixXd& transposed, const VectorXd& b,
                Index displacements, SystemKind& kind, RefinedSolver& solver);

}  // namespace ffcontact
