// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/active_set/active_set_system.hpp"

namespace ffcontact {

/// What a node of a surface does, and the equations of its next P and v (surface_newton).
struct NodeState {
  bool open = false, slips = false;
  Vector2d e = Vector2d::Zero();  ///< direction of the force where it slips
  double share = 0;               ///< rho / |tau_t|
  double given = 0, ratio = 0;    ///< rho = given - ratio P_n

  /// Is v = 0 its condition on a component?
  bool fixes(int component) const { return component == 0 ? !open : !slips; }
};

/// Pi(tau): what the law makes of tau.
Vector3d projected(const FrictionCone& cone, const Vector3d& tau);

NodeState node_state(const FrictionCone& cone, const Vector3d& tau);
/// Of a first guess; a slip without direction has no force.
NodeState node_state(const FrictionCone& cone, ContactState start);
ContactState contact_state(const NodeState& node);
ContactStates contact_states(const std::vector<NodeState>& nodes);

/// P - Pi(tau), tau = P - c v, which is 0 where P and v are in the law; rows 3 i + c.
class NaturalMap {
 public:
  /// @param held  rows without force and condition [3 p]
  NaturalMap(const CondensedContact& contact, const Flags& held);

  /// @param diagonal  of S on the primary rows [f]
  /// @param position  of CondensedContact [3 p]
  NaturalMap(const VectorXd& diagonal, const VectorXi& position,
             const Flags& held);

  /// c, the mean of diag(S) at a node.
  double stiffness(int node) const { return stiffness_[node]; }
  Vector3d tau(const ContactRows& rows, int node) const;
  /// What the nodes do by their rows [p].
  std::vector<NodeState> states(const NodalLaw& law,
                                const ContactRows& rows) const;
  /// sum |P - Pi(tau)|^2 / c over the rows that are not held, and P^2 / c over those beyond
  /// the nodes', where P = 0 is the condition.
  double merit(const NodalLaw& law, const ContactRows& rows) const;

 private:
  const Flags& held_;
  VectorXd stiffness_;  ///< [p]
};

}  // namespace ffcontact
