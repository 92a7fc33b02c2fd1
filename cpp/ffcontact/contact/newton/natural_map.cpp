// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/natural_map.hpp"

#include <algorithm>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Of the primary rows at a node; 0 where there are none.
double mean_diagonal(const VectorXd& diagonal, const VectorXi& position,
                     Index node) {
  double sum = 0;
  int count = 0;
  for (int c = 0; c < 3; ++c)
    if (const int k = position[3 * node + c]; k >= 0) {
      sum += diagonal[k];
      ++count;
    }
  return relative(sum, count);
}

}  // namespace

Vector3d projected(const FrictionCone& cone, const Vector3d& tau) {
  if (cone.bonded) return tau;
  const double rho = cone.bound(tau[0]), length = tau.tail<2>().norm();
  const double share = length > rho ? rho / length : 1;
  return {std::min(tau[0], 0.0), share * tau[1], share * tau[2]};
}

NodeState node_state(const FrictionCone& cone, const Vector3d& tau) {
  NodeState node;
  if (cone.bonded) return node;
  node.open = tau[0] >= 0;
  const double rho = cone.bound(tau[0]), length = tau.tail<2>().norm();
  node.slips = rho == 0 || length > rho;
  if (length > 0) node.e = tau.tail<2>() / length;
  if (length > 0) node.share = std::min(rho / length, 1.0);
  const bool at_limit = cone.at_limit(tau[0]);
  node.given = at_limit ? cone.limit : cone.cohesion;
  node.ratio = at_limit || node.open ? 0 : cone.friction;
  return node;
}

NodeState node_state(const FrictionCone& cone, ContactState start) {
  NodeState node;
  node.open = is_open(start) && !cone.bonded;
  node.slips = cone.frictionless() || node.open;
  return node;
}

ContactState contact_state(const NodeState& node) {
  if (node.open) return ContactState::open;
  return node.slips ? ContactState::slip_forward : ContactState::stick;
}

ContactStates contact_states(const std::vector<NodeState>& nodes) {
  ContactStates states;
  for (const NodeState& node : nodes) states.push_back(contact_state(node));
  return states;
}

NaturalMap::NaturalMap(const CondensedContact& contact, const Flags& held)
    : NaturalMap(contact.S.diagonal(), contact.position, held) {}

NaturalMap::NaturalMap(const VectorXd& diagonal, const VectorXi& position,
                       const Flags& held)
    : held_(held), stiffness_(position.size() / 3) {
  const double least = 1e-300, mean = diagonal.mean();
  for (Index i = 0; i < stiffness_.size(); ++i) {
    const double own = mean_diagonal(diagonal, position, i);
    stiffness_[i] = std::max(own > 0 ? own : mean, least);
  }
}

Vector3d NaturalMap::tau(const ContactRows& rows, int node) const {
  return rows.P.segment<3>(3 * node) -
         stiffness_[node] * rows.v.segment<3>(3 * node);
}

std::vector<NodeState> NaturalMap::states(const NodalLaw& law,
                                          const ContactRows& rows) const {
  std::vector<NodeState> states;
  for (int i = 0; i < law.node_count(); ++i)
    states.push_back(node_state(law.cone[i], tau(rows, i)));
  return states;
}

double NaturalMap::merit(const NodalLaw& law, const ContactRows& rows) const {
  double sum = 0;
  for (int i = 0; i < law.node_count(); ++i) {
    Vector3d missed =
        rows.P.segment<3>(3 * i) - projected(law.cone[i], tau(rows, i));
    for (int c = 0; c < 3; ++c)
      if (held_[3 * i + c]) missed[c] = 0;
    sum += missed.squaredNorm() / stiffness_[i];
  }
  const Index beyond = rows.P.size() - 3 * stiffness_.size();
  return sum + rows.P.tail(beyond).squaredNorm() / stiffness_.mean();
}

}  // namespace ffcontact
