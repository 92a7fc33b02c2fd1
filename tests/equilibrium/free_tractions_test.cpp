// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/free_tractions.hpp"

#include <gtest/gtest.h>

#include "support/problems.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

bool allowed(const ConeConditions& conditions, const Eigen::Vector2d& r) {
  return ((conditions.C * r - conditions.d).array() >= 0).all();
}

RC_GTEST_PROP(ConeConditions, of_coulomb_are_the_cone, (Random random)) {
  Problem problem = body(rectangle(1, 1, 1, 1), material(1, 0));
  set_friction(problem, *real(0.01, 2));
  const Eigen::Vector2d r = random_vector(2, random);
  const bool inside = r[0] <= 0 && std::abs(r[1]) <= -problem.law.friction[0] * r[0];
  RC_ASSERT(allowed(cone_conditions(problem.law, 0), r) == inside);
}

RC_GTEST_PROP(ConeConditions, of_tresca_are_a_half_strip, (Random random)) {
  Problem problem = body(rectangle(1, 1, 1, 1), material(1, 0));
  problem.law.slip_bound = everywhere(problem.line, *real(0.01, 1));
  const Eigen::Vector2d r = random_vector(2, random);
  const bool inside = r[0] <= 0 && std::abs(r[1]) <= problem.law.slip_bound[0];
  RC_ASSERT(allowed(cone_conditions(problem.law, 0), r) == inside);
}

TEST(ConeConditions, without_friction_leave_the_tangential_part_to_be_known) {
  const Problem problem = body(rectangle(1, 1, 1, 1), material(1, 0));
  const ConeConditions conditions = cone_conditions(problem.law, 0);
  EXPECT_TRUE(conditions.frictionless);
  EXPECT_EQ(conditions.C.rows(), 1);
  EXPECT_TRUE(allowed(conditions, {-1, 0}));
  EXPECT_FALSE(allowed(conditions, {1e-9, 0}));
}

TEST(ContactEdgeNumbers, are_the_inverse_of_the_lines_edges) {
  const Problem problem = body(rectangle(3, 2, 3, 2), material(1, 0), {left, bottom});
  const std::vector<int> number = contact_edge_numbers(problem.line, problem.edges);
  for (int e = 0; e < problem.line.edge_count(); ++e) EXPECT_EQ(number[problem.line.edge[e]], e);
  EXPECT_EQ(std::count_if(number.begin(), number.end(), [](int n) { return n >= 0; }), 5);
}

}  // namespace
}  // namespace ffcontact
