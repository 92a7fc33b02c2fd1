// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/newton/natural_map.hpp"

namespace ffcontact {

/// sum P P_row + v v_row = value
struct Term {
  int row;
  double P, v;
};
struct Equation {
  std::vector<Term> terms;
  double value = 0;
};

/// The conditions of the nodes' states on the next P and v (surface_newton), row by row.
class SurfaceEquations {
 public:
  /// All of them outlive it.
  /// @param held  of surface_trace [3 p]
  SurfaceEquations(const Flags& held, const NaturalMap& map,
                   const std::vector<NodeState>& states)
      : held_(held), map_(map), states_(states) {}

  const NodeState& state(int node) const { return states_[node]; }
  bool is_held(int row) const { return held_[row] != 0; }
  bool is_open(int node) const { return states_[node].open; }
  /// Is P = 0 the condition on all rows of a node?
  bool carries_nothing(int node) const {
    const NodeState& state = states_[node];
    return state.open && state.slips && state.share == 0 && state.given == 0;
  }
  /// Is v = 0 the condition on a row?
  bool is_fixed(int row) const { return states_[row / 3].fixes(row % 3); }

  /// Of a row that is not held.
  Equation equation(int row) const;

  /// What its value gains where rho of its node grows by 1.
  double value_by_bound(int row) const;

  /// D on the tangential rows, 0 on those that are held.
  Matrix2d derivative(int node) const;

  /// c
  double stiffness(int node) const { return map_.stiffness(node); }

 private:
  const Flags& held_;
  const NaturalMap& map_;
  const std::vector<NodeState>& states_;
};

}  // namespace ffcontact
