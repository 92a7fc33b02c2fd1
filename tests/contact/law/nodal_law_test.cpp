// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/nodal_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(NodalLaw, coulombs_bound_is_friction_times_compression) {
  const Problem problem = example_1(Multiplier::force, 2);
  const NodalLaw law = nodal_law(problem.law, problem.line);
  EXPECT_EQ(law.cone[0].bound(-4), 2);
  EXPECT_EQ(law.cone[0].bound(4), 0);
  EXPECT_FALSE(law.cone[0].frictionless());
}

TEST(NodalLaw, trescas_bound_is_in_the_units_of_the_multiplier) {
  Problem problem = example_1(Multiplier::pressure, 2);  // four edges of 20 mm
  problem.law.slip_bound = everywhere(problem.line, 3);
  EXPECT_EQ(nodal_law(problem.law, problem.line).cone[1].bound(-7), 3);
  problem.law.multiplier = Multiplier::force;
  EXPECT_DOUBLE_EQ(nodal_law(problem.law, problem.line).cone[0].bound(-7), 30);
  EXPECT_DOUBLE_EQ(nodal_law(problem.law, problem.line).cone[1].bound(-7), 60);
}

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

}  // namespace
}  // namespace ffcontact
