// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid/step_conditions.hpp"

#include <utility>

namespace ffcontact {

namespace {

bool has_no_force(const SurfaceEquations& equations, int row) {
  return equations.carries_nothing(row / 3) ||
         (row % 3 == 0 && equations.is_open(row / 3));
}

}  // namespace

void StepConditions::put(const VectorXd& v_prescribed,
                         const VectorXd& carried) {
  v_prescribed_ = v_prescribed;
  if (carried.size() > 0)
    v_prescribed_ -= unknowns_.compliance.cwiseProduct(carried.head(nodal()));
}

VectorXd StepConditions::y_of(const VectorXd& v, const VectorXd& P) const {
  VectorXd y = VectorXd::Zero(step_.diagonal_of_all().size());
  unknowns_.for_rows(
      [&](int row, int k) { y[k] = v[row] - v_of(row, 0, P[row]); });
  return y;
}

ContactRows StepConditions::rows_of(const VectorXd& y,
                                    const VectorXd& F) const {
  const VectorXd none = VectorXd::Zero(nodal() + y.size());
  ContactRows rows{none, none};
  rows.P.tail(y.size()) = F;
  rows.v.tail(y.size()) = y;
  unknowns_.for_rows([&](int row, int k) {
    rows.P[row] = std::exchange(rows.P[nodal() + k], 0);
    rows.v[row] = v_of(row, y[k], F[k]);
  });
  return rows;
}

void StepConditions::fix(const SurfaceEquations& equations, VectorXd& y) const {
  unknowns_.for_rows([&](int row, int k) {
    if (equations.is_fixed(row) && !step_.is_sprung(equations, row))
      y[k] = -v_prescribed_[row];
  });
}

void StepConditions::relax(const SurfaceEquations& equations, const VectorXd& F,
                           VectorXd& y) const {
  unknowns_.for_rows([&](int row, int k) {
    if (step_.is_sprung(equations, row))
      y[k] -= v_of(row, y[k], F[k]) / (1 + yielding(row));
  });
}

VectorXd StepConditions::missed(const SurfaceEquations& equations,
                                const VectorXd& y, const VectorXd& F) const {
  VectorXd missed = F;
  unknowns_.for_rows([&](int row, int k) {
    if (step_.is_sprung(equations, row))
      missed[k] = step_.spring(row) * v_of(row, y[k], F[k]);
    else if (equations.is_fixed(row))
      missed[k] = 0;
    else if (row % 3 > 0)
      missed[k] += friction_missed(equations, row / 3, y, F)[row % 3 - 1];
  });
  return missed;
}

/// w (1 - e e') (y + v_prescribed)_t - (k - mu P_n) e of a node that slips.
Vector2d StepConditions::friction_missed(const SurfaceEquations& equations,
                                         int node, const VectorXd& y,
                                         const VectorXd& F) const {
  const NodeState& state = equations.state(node);
  const Vector3i k = unknowns_.of_row.segment<3>(3 * node);
  Vector2d slip = Vector2d::Zero();
  for (int c = 1; c < 3; ++c)
    if (k[c] >= 0) slip[c - 1] = y[k[c]] + v_prescribed_[3 * node + c];
  const double bound = state.given - (k[0] >= 0 ? state.ratio * F[k[0]] : 0);
  return step_.slip_stiffness(equations, node) * slip - bound * state.e;
}

void StepConditions::settle(const SurfaceEquations& equations,
                            const VectorXd& missed, ContactRows& rows) const {
  unknowns_.for_rows([&](int row, int k) {
    const double of_layer = yielding(row) / (1 + yielding(row)),
                 left = has_no_force(equations, row) ? rows.P[row]
                                                     : of_layer * missed[k];
    rows.P[nodal() + k] += left;
    rows.P[row] -= left;
    rows.v[row] -= unknowns_.compliance[row] * left;
  });
}

}  // namespace ffcontact
