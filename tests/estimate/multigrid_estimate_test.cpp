// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "support/by_multigrid.hpp"
#include "support/solid_estimates.hpp"

/// Estimates of solids so large that u* is solved by multigrid, not to rounding.
namespace ffcontact {
namespace {

using namespace test;

/// Pressed by a traction, on planes of symmetry or held by contact alone.
SolidProblem pressed(bool symmetric) {
  SolidProblem problem(brick({32, 16, 12}, {80, 40, 40}), 0.5);
  problem.load(high_z, {0, 0, -5});
  problem.load(high_x, {-0.5, 0, 0});
  if (symmetric) {
    problem.guide(low_x, 0);
    problem.guide(low_y, 1);
  }
  return problem;
}

TEST(EstimatesByMultigrid,
     balance_every_tetrahedron_and_are_those_of_a_factor) {
  for (const bool symmetric : {true, false}) {
    const SolidProblem problem = pressed(symmetric);
    ContactSolution<3> solution = problem.solve(by(LinearSolver::direct));
    ASSERT_TRUE(solution.accepted({}));
    RelaxationSettings settings;
    settings.steps = 4;
    const Estimate<3> by_factor = estimate(problem, solution, settings);
    solution.stiffness = nullptr;
    const Estimate<3> by_multigrid = estimate(problem, solution, settings);
    EXPECT_TRUE(by_multigrid.admissible) << by_multigrid.reason;
    EXPECT_LT(by_multigrid.equilibrium.largest(), 1e-12);
    EXPECT_NEAR(by_multigrid.e, by_factor.e, 1e-6 * by_factor.e);
    EXPECT_NE(by_multigrid.e, by_factor.e);
  }
}

}  // namespace
}  // namespace ffcontact
