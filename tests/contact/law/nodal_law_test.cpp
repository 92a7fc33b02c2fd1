// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/nodal_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ffcontact/contact/law/cones_of_law.hpp"
#include "support/problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(NodalLaw, a_given_slip_limit_freezes_coulombs_bound) {
  const Problem problem = example_1(Multiplier::force, 2);
  const NodalLaw law = nodal_law(problem.law, problem.line);
  const NodalLaw given =
      with_given_slip_limit(law, (VectorXd(5) << -2, -1, 0, 1, -4).finished());
  EXPECT_TRUE(given.is_convex());
  const double expected[] = {1, 0.5, 0, 0, 2};
  for (int i = 0; i < 5; ++i) EXPECT_EQ(given.cone[i].bound(-100), expected[i]);
}

/// A defect of what is not a number is no small one.
TEST(NodalLaw, is_violated_by_what_is_not_finite) {
  const NodalLaw law = nodal_law(example_1(Multiplier::force, 2).law,
                                 example_1(Multiplier::force, 2).line);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double spoilt : {std::nan(""), infinity, -infinity}) {
    VectorXd P = VectorXd::Zero(10), v = P;
    P[4] = spoilt;
    EXPECT_EQ(law_violation(law, P, v, {1, 0}), infinity);
    std::swap(P, v);
    EXPECT_EQ(law_violation(law, P, v, {1, 0}), infinity);
  }
}

NodalLaw one_node(double friction) {
  NodalLaw law;
  law.cone.resize(1);
  law.cone[0].friction = friction;
  return law;
}

/// Where nothing pushes yet, a given bound is missed by as much as can be.
TEST(NodalLaw, slip_without_the_given_friction_violates_it) {
  NodalLaw law = one_node(0);
  law.cone[0].cohesion = 1e-9;
  EXPECT_EQ(law_violation(law, Vector2d(0, 0), Vector2d(0, 3), {3, 0}), 1);
  EXPECT_EQ(law_violation(law, Vector2d(0, 0), Vector2d(0, 0), {3, 0}), 0);
  EXPECT_EQ(law_violation(law, Vector2d(0, -1e-9), Vector2d(0, 3), {3, 0}), 0);
  EXPECT_EQ(law_violation(law, Vector2d(0, 0), Vector2d(0, 3), {3, 0}, {1}), 0);
  law.cone.push_back({1});  // idle, no scale of the other one
  const VectorXd none = VectorXd::Zero(4);
  EXPECT_EQ(law_violation(law, none, Vector4d(0, 3, 0, 0), {3, 0}, {0, 1}), 1);
}

/// Of P = (-2, 0.6, 0.8) at the bound of mu = 1/2.
TEST(NodalLaw, violation_is_the_smaller_of_two_that_must_vanish) {
  const Vector3d P(-2, 0.6, 0.8), along = -Vector3d(0, 0.6, 0.8);
  const auto violation = [&](const Vector3d& force, const Vector3d& v) {
    return law_violation(one_node(0.5), force, v, {10, 2});
  };
  EXPECT_LT(violation(P, 5 * along), 1e-15);
  EXPECT_NEAR(violation(P, -5 * along), 0.5, 1e-15);  // |v_t| < 2 |P_t|
  EXPECT_NEAR(violation(P, -50 * along), 1, 1e-15);   // 2 |P_t| < |v_t|
  EXPECT_NEAR(violation(P, {-3, 0, 0}), 0.3, 1e-15);  // |v_n| < |P_n|
  EXPECT_NEAR(violation(P, {-30, 0, 0}), 1, 1e-15);   // |P_n| < |v_n|
  EXPECT_NEAR(violation(P, {1, 0, 0}), 0.1, 1e-15);   // penetrates
  EXPECT_NEAR(violation({-2, 1.5, 0}, {0, 0, 0}), 0.25, 1e-15);
  EXPECT_NEAR(violation({1, 0, 0}, {0, 0, 0}), 0.5, 1e-15);
  EXPECT_EQ(violation({-2, std::nan(""), 0}, {0, 0, 0}), INFINITY);
}

}  // namespace
}  // namespace ffcontact
