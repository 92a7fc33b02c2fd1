// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/kinetic_friction.hpp"

#include <gtest/gtest.h>

#include "support/cases.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr ContactState slips = ContactState::slip_backward,
                       sticks = ContactState::stick;

/// A line of four edges, the first two nodes of which have slipped.
struct KineticLine {
  ContactLine line = block_with_three_zones(4).line;
  ContactStates last =
      ContactStates{slips, slips, sticks, ContactState::open, sticks};
  ContactLaw<2> law;
  KineticFriction kinetic;

  KineticLine() {
    const int p = line.node_count(), m = line.edge_count();
    law.friction = VectorXd::Constant(p, 0.5);
    kinetic.friction = VectorXd::Constant(p, 0.2);
    law.between_nodes = {Matrix2Xd::Constant(2, m, 0.45),
                         Matrix2Xd::Constant(2, m, 0.55)};
    kinetic.between_nodes = {Matrix2Xd::Constant(2, m, 0.15),
                             Matrix2Xd::Constant(2, m, 0.25)};
  }
};

TEST(KineticFriction, counts_where_nodes_slipped) {
  const KineticLine s;
  const VectorXd friction =
      friction_after(s.last, s.law.friction, s.kinetic.friction);
  EXPECT_EQ(friction, VectorXd({{0.2, 0.2, 0.5, 0.5, 0.5}}));
}

TEST(KineticFriction,
     is_linear_between_a_node_that_slipped_and_one_that_did_not) {
  const KineticLine s;
  const ContactLaw<2> law = law_after(s.last, s.law, s.line, s.kinetic);
  for (int e = 0; e < s.line.edge_count(); ++e) {
    const Vector2i nodes = s.line.edge_node.col(e);
    const int slipped = (nodes[0] < 2) + (nodes[1] < 2);
    const Vector2d least = law.between_nodes.least.col(e),
                   most = law.between_nodes.most.col(e);
    if (slipped == 1) {
      EXPECT_EQ(least, law.friction(nodes));
      EXPECT_EQ(most, law.friction(nodes));
    } else {
      EXPECT_EQ(least, Vector2d::Constant(slipped == 2 ? 0.15 : 0.45));
      EXPECT_EQ(most, Vector2d::Constant(slipped == 2 ? 0.25 : 0.55));
    }
  }
}

TEST(KineticFriction, a_node_at_the_bound_that_has_not_moved_has_stuck) {
  const ContactStates states =
      states_of_step({slips, slips, ContactState::open},
                     Eigen::Vector3d(1e-12, 1e-3, 0), 1e-10);
  EXPECT_EQ(states, (ContactStates{sticks, slips, ContactState::open}));
}

TEST(KineticFriction, is_not_above_that_of_what_sticks) {
  const VectorXd at_rest = VectorXd::Constant(2, 0.3);
  const auto refusal_of = [&](double value, int count) {
    return refusal(
        [&] { require_kinetic(VectorXd::Constant(count, value), at_rest); });
  };
  EXPECT_TRUE(says(refusal_of(0.4, 2), "is 0.4 where friction is 0.3"));
  EXPECT_TRUE(says(refusal_of(-0.1, 2), "kineticfriction"));
  EXPECT_TRUE(says(refusal_of(0, 1), "kineticfriction"));
  EXPECT_EQ(refusal_of(0.3, 2), "accepted");
}

}  // namespace
}  // namespace ffcontact
