// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/condensed/contact_rows.hpp"
#include "ffcontact/contact/multigrid/step_multigrid.hpp"

namespace ffcontact {

/// What the states of the nodes ask of y, and of the forces F = K u - b on it, from which
///     P = F,   v = y + v_prescribed + gamma F
/// at the rows of the nodes. A layer that carries P0 already gives way by gamma (F - P0).
class StepConditions {
 public:
  /// Both outlive it.
  StepConditions(const SurfaceUnknowns& unknowns, const StepMultigrid& step)
      : unknowns_(unknowns), step_(step) {}

  /// @param carried  P0 of all rows; empty: 0
  void put(const VectorXd& v_prescribed, const VectorXd& carried);

  /// Less gamma P0.
  const VectorXd& v_prescribed() const { return v_prescribed_; }

  /// y for v and P of the nodes, 0 beyond them.
  VectorXd y_of(const VectorXd& v, const VectorXd& P) const;
  /// P and v of the nodes, behind them y and the forces on y that are no P.
  ContactRows rows_of(const VectorXd& y, const VectorXd& F) const;

  /// gamma K_kk, of a layer beside the body's own compliance.
  double yielding(int row) const {
    return unknowns_.compliance[row] * step_.stiffness(row);
  }

  /// v = 0 where that is the condition and there is no layer.
  void fix(const SurfaceEquations& equations, VectorXd& y) const;
  /// v = 0 on sprung rows if no other y changed, so that what these miss is no larger than
  /// the forces of the others' change, however stiff the layer is.
  void relax(const SurfaceEquations& equations, const VectorXd& F,
             VectorXd& y) const;
  /// What the equations of the states and of equilibrium lack, 0 where y is given.
  VectorXd missed(const SurfaceEquations& equations, const VectorXd& y,
                  const VectorXd& F) const;
  /// Exactly no force where that is the condition, so that a body without contact has no
  /// forces of rounding. On a soft layer P goes to what the conditions ask for, as the
  /// rounding of F is large in gamma F:   P - gamma K / (1 + gamma K) missed.
  /// What is left of F is a force on y.
  void settle(const SurfaceEquations& equations, const VectorXd& missed,
              ContactRows& rows) const;

 private:
  Index nodal() const { return unknowns_.of_row.size(); }
  double v_of(int row, double y, double F) const {
    return y + v_prescribed_[row] + unknowns_.compliance[row] * F;
  }
  Vector2d friction_missed(const SurfaceEquations& equations, int node,
                           const VectorXd& y, const VectorXd& F) const;

  const SurfaceUnknowns& unknowns_;
  const StepMultigrid& step_;
  VectorXd v_prescribed_;  ///< less gamma P0
};

}  // namespace ffcontact
