// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/natural_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/friction_cones.hpp"

namespace ffcontact {
namespace {

using namespace test;

bool is_inside(const FrictionCone& cone, const Vector3d& P) {
  return P[0] <= 0 && P.tail<2>().norm() <= cone.bound(P[0]) + 1e-14;
}

/// The normal part of a projection does not depend on the tangential one, which is the
/// nearest in the disc of that normal part.
RC_GTEST_PROP(NaturalMap, projects_onto_the_law, (Random random)) {
  const FrictionCone cone = any_cone(random);
  const Vector3d tau = 2 * random_vector(3, random), P = projected(cone, tau);
  RC_ASSERT(is_inside(cone, P));
  RC_ASSERT((projected(cone, P) - P).norm() <= 1e-15);
  RC_ASSERT(P[0] == std::min(tau[0], 0.0));
  const double away = (P - tau).tail<2>().norm();
  for (int k = 0; k < 20; ++k) {
    Vector3d other = random_vector(3, random);
    other[0] = P[0];
    if (is_inside(cone, other))
      RC_ASSERT((other - tau).tail<2>().norm() >= away - 1e-13);
  }
}

/// P_t = -rho e where a node slips, with rho = given - ratio P_n and e the way of tau.
RC_GTEST_PROP(NaturalMap, states_are_the_branch_of_the_projection,
              (Random random)) {
  const FrictionCone cone = any_cone(random);
  const Vector3d tau = 2 * random_vector(3, random), P = projected(cone, tau);
  const NodeState node = node_state(cone, tau);
  RC_ASSERT(node.open == (P[0] == 0));
  RC_ASSERT(node.slips == (P.tail<2>().norm() < tau.tail<2>().norm()));
  RC_ASSERT(node.fixes(0) == !node.open);
  RC_ASSERT(node.fixes(1) == !node.slips && node.fixes(2) == !node.slips);
  RC_ASSERT(std::abs(node.e.norm() - 1) < 1e-15);
  if (!node.slips) return;
  const double rho = node.given - node.ratio * P[0];
  RC_ASSERT((P.tail<2>() - rho * node.e).norm() < 1e-15);
  RC_ASSERT((P.tail<2>() - node.share * tau.tail<2>()).norm() < 1e-15);
}

TEST(NaturalMap, first_guesses_have_no_force_of_friction) {
  FrictionCone cone;
  EXPECT_TRUE(node_state(cone, ContactState::stick).slips);
  cone.friction = 0.5;
  const NodeState stick = node_state(cone, ContactState::stick),
                  open = node_state(cone, ContactState::open);
  EXPECT_FALSE(stick.open || stick.slips);
  EXPECT_TRUE(open.open && open.slips);
  EXPECT_EQ(open.e, Vector2d::Zero());
  EXPECT_EQ(contact_states({stick, open}),
            ContactStates({ContactState::stick, ContactState::open}));
}

/// Two nodes, the second without a primary row along t2, and a row beyond them.
TEST(NaturalMap, merit_is_what_the_law_misses) {
  VectorXd diagonal(5);
  diagonal << 1, 2, 3, 4, 8;
  VectorXi position(6);
  position << 0, 1, 2, 3, 4, -1;
  const Flags held{0, 0, 0, 0, 0, 1};
  const NaturalMap map(diagonal, position, held);
  EXPECT_EQ(map.stiffness(0), 2);
  EXPECT_EQ(map.stiffness(1), 6);
  NodalLaw law;
  law.cone.resize(2);
  law.cone[0].friction = law.cone[1].friction = 0.5;
  ContactRows rows{VectorXd::Zero(7), VectorXd::Zero(7)};
  rows.P << -2, 0.6, 0.8, -1, 0, 0, 0;  // at the bound, and sticking
  rows.v << 0, -3, -4, 0, 0, 9, 0;      // along its force
  EXPECT_LT(map.merit(law, rows), 1e-30);
  rows.v[0] = 0.25;  // leaves by it: P_n = -2 ought to be -2.5
  EXPECT_NEAR(map.merit(law, rows), (0.25 + 0.0625) / 2, 1e-15);
  rows.v[0] = 0;
  rows.P[5] = 3;  // held
  rows.P[6] = 2;
  EXPECT_NEAR(map.merit(law, rows), 4 / 4.0, 1e-15);
}

}  // namespace
}  // namespace ffcontact
