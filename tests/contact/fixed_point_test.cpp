// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/fixed_point.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/contact_solution.hpp"
#include "support/cases.hpp"

namespace ffcontact {
namespace {

using namespace test;

ContactSolution by_fixed_point(const Problem& problem) {
  ContactSettings settings;
  settings.solver = ContactSolver::fixed_point;
  return solved(problem, settings);
}

RC_GTEST_PROP(FixedPoint, reaches_the_solution_of_newtons_method, ()) {
  const Problem problem = problem_of(*random_case(0.3));
  const ContactSolution newton = solved(problem),
                        fixed = by_fixed_point(problem);
  RC_ASSERT(fixed.status == ContactStatus::converged);
  RC_ASSERT(fixed.complementarity <= 1e-10);
  RC_ASSERT(relative_difference(fixed.displacement, newton.displacement) <
            1e-7);
}

TEST(FixedPoint, contracts_on_example_1) {
  const ContactSolution solution = by_fixed_point(example_1(Multiplier::force));
  EXPECT_EQ(solution.status, ContactStatus::converged);
  ASSERT_GT(solution.history.size(), 3u);
  EXPECT_LT(solution.history.back(), 1e-8);
  EXPECT_LT(
      relative_difference(solution.displacement,
                          solved(example_1(Multiplier::force)).displacement),
      1e-8);
}

TEST(FixedPoint, of_trescas_law_is_one_step) {
  Problem problem = example_2(Multiplier::force, 0, 8);
  problem.law.slip_bound = everywhere(problem.line, 0.2);
  const ContactSolution fixed = by_fixed_point(problem),
                        newton = solved(problem);
  EXPECT_EQ(fixed.status, ContactStatus::converged);
  EXPECT_LE(fixed.history.size(), 1u);
  EXPECT_LT(relative_difference(fixed.displacement, newton.displacement),
            1e-12);
}

}  // namespace
}  // namespace ffcontact
