// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/threads.hpp"

#include <gtest/gtest.h>

#include "support/problems.hpp"
#include "support/solid_problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(Threads, do_not_change_a_digit_of_contact) {
  for (const Multiplier multiplier : both_multipliers) {
    const Problem problem = example_1(multiplier, 64);
    const auto solve = [&] { return solved(problem); };
    const ContactSolution<2> one = on_threads(1, solve),
                             two = on_threads(2, solve);
    EXPECT_EQ(two.state, one.state);
    EXPECT_EQ(two.displacement, one.displacement);
    EXPECT_EQ(two.pressure, one.pressure);
  }
}

/// Large enough for threads to share the factor; in both precisions, and by multigrid.
TEST(Threads, do_not_change_a_digit_of_contact_of_solids) {
  const SolidProblem problem =
      block_problem(brick({24, 12, 12}, {80, 40, 40}), BlockCase::press_x, 0.5);
  ContactSettings in_double, in_single, by_multigrid;
  in_single.single_precision_from = 0;
  by_multigrid.linear = LinearSolver::multigrid;
  for (const ContactSettings& settings : {in_double, in_single, by_multigrid}) {
    const auto solve = [&] { return problem.solve(settings); };
    const ContactSolution<3> one = on_threads(1, solve),
                             two = on_threads(2, solve);
    EXPECT_EQ(two.displacement, one.displacement);
    EXPECT_EQ(two.force, one.force);
  }
}

}  // namespace
}  // namespace ffcontact
