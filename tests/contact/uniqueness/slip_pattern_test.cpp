// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/uniqueness/slip_pattern.hpp"

#include <gtest/gtest.h>

namespace ffcontact::test {
namespace {

/// Nodes: open and moved forward, open and still, slips backward, sticks, at the limit.
struct Nodes {
  NodalLaw law{std::vector<FrictionCone>(5)};
  Matrix2Xd P = Matrix2Xd::Zero(2, 5), force;
  VectorXd slip = VectorXd::Zero(5);

  Nodes() {
    for (FrictionCone& cone : law.cone) cone.friction = 0.5;
    law.cone[4].limit = 1;
    P.row(0) << 0, 0, -2, -4, -4;
    P.row(1) << 0, 0, 1, 1.5, -1;
    force = P;
    slip << 1, 0, -1, 0, 2;
  }
  SlipPattern pattern() const { return slip_pattern(law, P, force, slip); }
};

TEST(slip_pattern, signs_are_those_of_slip_or_against_friction) {
  Nodes nodes;
  EXPECT_EQ(nodes.pattern().sign, (VectorXd(5) << 1, 1, -1, -1, 1).finished());
  // a sticking node goes by its force
  nodes.force(1, 3) = -0.1;
  EXPECT_EQ(nodes.pattern().sign, (VectorXd(5) << 1, 1, -1, 1, 1).finished());
  // nodes before the first sign take it
  nodes.slip[0] = 0;
  EXPECT_EQ(nodes.pattern().sign, (VectorXd(5) << -1, -1, -1, 1, 1).finished());
}

TEST(slip_pattern, sticks_below_the_bound_of_a_closed_node) {
  EXPECT_EQ(Nodes().pattern().sticks, (std::vector<char>{0, 0, 0, 1, 0}));
  Nodes nodes;
  nodes.P(1, 2) *= 1 - 1e-8;  // what another solver leaves
  EXPECT_EQ(nodes.pattern().sticks, Nodes().pattern().sticks);
}

TEST(slip_pattern, weighs_the_slope_of_the_bound) {
  Nodes nodes;
  nodes.law.cone[1].friction = 0.25;
  EXPECT_EQ(largest_friction(nodes.law), 0.5);
  EXPECT_EQ(nodes.pattern().weight(0.5),
            (VectorXd(5) << 1, 0.5, -1, -1, 0).finished());
  EXPECT_EQ(nodes.pattern().weight(0), VectorXd::Zero(5));
  EXPECT_TRUE(nodes.pattern().reaches_limit);
  nodes.law.cone[4].limit = 3;
  EXPECT_FALSE(nodes.pattern().reaches_limit);
  EXPECT_EQ(nodes.pattern().weight(0.5)[4], 1);
}

}  // namespace
}  // namespace ffcontact::test
