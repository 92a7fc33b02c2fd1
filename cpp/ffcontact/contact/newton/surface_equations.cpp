// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/surface_equations.hpp"

namespace ffcontact {

Equation SurfaceEquations::equation(int row) const {
  const int node = row / 3, component = row % 3;
  if (is_fixed(row)) return {{{row, 0, 1}}, 0};
  if (component == 0) return {{{row, 1, 0}}, 0};
  const NodeState& state = states_[node];
  Equation equation;
  equation.value = state.given * value_by_bound(row);
  const Matrix2d D = derivative(node);
  for (int c = 1; c < 3; ++c)
    if (const int other = 3 * node + c; !held_[other]) {
      const double d = D(component - 1, c - 1);
      equation.terms.push_back(
          {other, (c == component) - d, map_.stiffness(node) * d});
    }
  if (state.ratio != 0 && !held_[3 * node])
    equation.terms.push_back(
        {3 * node, state.ratio * state.e[component - 1], 0});
  return equation;
}

double SurfaceEquations::value_by_bound(int row) const {
  return is_fixed(row) || row % 3 == 0 ? 0 : states_[row / 3].e[row % 3 - 1];
}

Matrix2d SurfaceEquations::derivative(int node) const {
  const NodeState& state = states_[node];
  Matrix2d D =
      state.share * (Matrix2d::Identity() - state.e * state.e.transpose());
  for (int c = 0; c < 2; ++c)
    if (held_[3 * node + 1 + c]) {
      D.row(c).setZero();
      D.col(c).setZero();
    }
  return D;
}

}  // namespace ffcontact
