// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/kinetic_friction.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// On the edges both of whose nodes slipped that of what slips, and of mixed ones the chord.
void put_kinetic(const ContactStates& last, const ContactLine& line,
                 const VectorXd& friction, const Matrix2Xd& kinetic,
                 Matrix2Xd& between) {
  for (int e = 0; e < line.edge_count(); ++e) {
    const Vector2i nodes = line.edge_node.col(e);
    const bool first = slip_sign(last[nodes[0]]) != 0,
               second = slip_sign(last[nodes[1]]) != 0;
    if (first && second && kinetic.size() > 0)
      between.col(e) = kinetic.col(e);
    else if (first || second)
      between.col(e) = friction(nodes);
  }
}

}  // namespace

void require_kinetic(const VectorXd& kinetic, const VectorXd& at_rest) {
  require_size("kineticfriction", kinetic.size(), at_rest.size());
  require_nonnegative("kineticfriction", kinetic);
  for (Index i = 0; i < kinetic.size(); ++i)
    if (kinetic[i] > at_rest[i])
      refuse("kineticfriction is ", kinetic[i], " where friction is ",
             at_rest[i],
             ": what slips has no larger coefficient than what sticks");
}

ContactStates states_of_step(ContactStates states,
                             const Ref<const VectorXd>& slip, double least) {
  for (Index i = 0; i < slip.size(); ++i)
    if (slip_sign(states[i]) != 0 && slip[i] <= least)
      states[i] = ContactState::stick;
  return states;
}

VectorXd friction_after(const ContactStates& last, const VectorXd& at_rest,
                        const VectorXd& kinetic) {
  require_size("states of the load step before", count_of(last),
               at_rest.size());
  VectorXd friction = at_rest;
  for (Index i = 0; i < friction.size(); ++i)
    if (slip_sign(last[i]) != 0) friction[i] = kinetic[i];
  return friction;
}

EdgeRange between_nodes_after(const ContactStates& last,
                              const ContactLine& line, EdgeRange between,
                              const VectorXd& friction,
                              const EdgeRange& kinetic) {
  if (between.least.size() == 0) return between;
  put_kinetic(last, line, friction, kinetic.least, between.least);
  put_kinetic(last, line, friction, kinetic.most, between.most);
  return between;
}

}  // namespace ffcontact
