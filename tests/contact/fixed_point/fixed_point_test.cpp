// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/fixed_point/fixed_point.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/contact_solution.hpp"
#include "support/cases.hpp"

namespace ffcontact {
namespace {

using namespace test;

ContactSolution<2> by_fixed_point(const Problem& problem) {
  ContactSettings settings;
  settings.solver = ContactSolver::fixed_point;
  return solved(problem, settings);
}

RC_GTEST_PROP(FixedPoint, reaches_the_solution_of_newtons_method, ()) {
  const Problem problem = problem_of(*random_case(0.3));
  const ContactSolution<2> newton = solved(problem),
                           fixed = by_fixed_point(problem);
  RC_ASSERT(fixed.status == ContactStatus::converged);
  RC_ASSERT(fixed.complementarity <= 1e-10);
  RC_ASSERT(relative_difference(fixed.displacement, newton.displacement) <
            1e-7);
}

TEST(FixedPoint, contracts_on_example_1) {
  const ContactSolution<2> solution =
      by_fixed_point(example_1(Multiplier::force));
  EXPECT_EQ(solution.status, ContactStatus::converged);
  ASSERT_GT(solution.history.size(), 3u);
  EXPECT_LT(solution.history.back(), 1e-8);
  EXPECT_LT(
      relative_difference(solution.displacement,
                          solved(example_1(Multiplier::force)).displacement),
      1e-8);
}

/// Every node sticks, v = 0, and the multiplier of the prescribed end is free: P(g) takes
/// the one for which a node is at the bound of g, and Coulomb's bound is above it.
TEST(FixedPoint, sticks_where_only_the_given_bound_is_reached) {
  for (const unsigned seed : {19u, 56u, 66u, 153u}) {
    Random random(seed);
    Case c;
    c.mesh = irregular(3, 3, 6, 4, random);
    c.support = Support::symmetric_right;
    c.multiplier = Multiplier::pressure;
    c.mu = 0.2739;
    c.nu = 0.0396;
    c.on_left = {-1, -0.868};
    c.on_top = {0.228, -3.098};
    c.in_body = {-0.0344, -0.05};
    const ContactSolution<2> fixed = by_fixed_point(problem_of(c));
    EXPECT_EQ(fixed.status, ContactStatus::converged) << seed;
    for (const ContactState state : fixed.state)
      EXPECT_EQ(state, ContactState::stick) << seed;
  }
}

/// A body moved along its foundation: there is no pressure to tell friction's direction.
TEST(FixedPoint, slides_where_it_touches_without_pressure) {
  for (const double shift : {1e-3, -1e-3}) {
    Problem problem = body(rectangle(4, 2, 4, 2), material(1, 0));
    clamp(problem, top, [&](const Vector2d&) { return Vector2d(shift, 0); });
    set_friction(problem, 0.5);
    const ContactSolution<2> fixed = by_fixed_point(problem);
    EXPECT_EQ(fixed.status, ContactStatus::converged);
    for (const ContactState state : fixed.state)
      EXPECT_EQ(state, shift > 0 ? ContactState::slip_forward
                                 : ContactState::slip_backward);
    EXPECT_LT(fixed.force.cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(FixedPoint, of_trescas_law_is_one_step) {
  Problem problem = example_2(Multiplier::force, 0, 8);
  problem.law.slip_bound = everywhere(problem.line, 0.2);
  const ContactSolution<2> fixed = by_fixed_point(problem),
                           newton = solved(problem);
  EXPECT_EQ(fixed.status, ContactStatus::converged);
  EXPECT_LE(fixed.history.size(), 1u);
  EXPECT_LT(relative_difference(fixed.displacement, newton.displacement),
            1e-12);
}

}  // namespace
}  // namespace ffcontact
