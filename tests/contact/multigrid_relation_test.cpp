// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid_relation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/contact/multigrid/step_multigrid.hpp"
#include "ffcontact/linear/norms.hpp"
#include "support/by_multigrid.hpp"
#include "support/pressed_bricks.hpp"
#include "support/solid_stacks.hpp"
#include "support/threads.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(MultigridRelation, has_the_answer_of_a_factor) {
  for (const BlockCase loads : {BlockCase::press, BlockCase::press_x,
                                BlockCase::shear, BlockCase::lift})
    for (const double mu : {0.0, 0.5, 2.0})
      expect_same(block_problem(brick({8, 4, 4}, {80, 40, 40}), loads, mu));
}

TEST(MultigridRelation, has_it_along_directions_that_turn) {
  Random random(1);
  SolidProblem problem =
      block_problem(brick({8, 4, 4}, {80, 40, 40}), BlockCase::shear, 0.5);
  problem.surface = turned_at_random(problem.surface, 0.2, random);
  expect_same(problem);
}

TEST(MultigridRelation, has_it_of_a_load_step_and_gaps) {
  Random random(1);
  SolidProblem problem =
      block_problem(brick({8, 4, 4}, {80, 40, 40}), BlockCase::press, 0.5);
  const int nodes = problem.surface.node_count();
  problem.law.previous = 1e-2 * random_matrix(2, nodes, random);
  problem.law.gap = 1e-3 * random_vector(nodes, random).cwiseAbs();
  expect_same(problem);
}

TEST(MultigridRelation, has_it_of_a_body_that_contact_alone_holds) {
  SolidProblem problem(brick({8, 4, 4}, {80, 40, 40}), 0.5);
  problem.load(high_z, {0.5, 0.2, -5});
  const ContactSolution<3> one = problem.solve(by(LinearSolver::multigrid)),
                           other = problem.solve(by(LinearSolver::direct));
  ASSERT_TRUE(one.accepted({}));
  EXPECT_EQ(one.multigrid, Multigrid::used);
  EXPECT_LE(max_norm(one.force - other.force), 1e-8 * max_norm(other.force));
}

TEST(MultigridRelation, starts_from_rows_that_are_near) {
  const ColdAndWarm found(
      block_problem(brick({8, 4, 4}, {80, 40, 40}), BlockCase::lift, 0.5));
  EXPECT_LT(found.warm.iterations, found.cold.iterations);
}

/// From what is of another load, and from nonsense.
TEST(MultigridRelation, gets_there_from_rows_that_are_far) {
  Random random(1);
  for (const double mu : {0.5, 2.0}) {
    const SolidProblem problem =
        block_problem(brick({8, 4, 4}, {80, 40, 40}), BlockCase::shear, mu);
    ContactSettings settings = by(LinearSolver::multigrid);
    const ContactSolution<3> cold = problem.solve(settings);
    for (int k = 0; k < 10; ++k) {
      const double size = std::pow(10, k - 5);
      settings.near = {size * random_vector(cold.force.size(), random),
                       1e-3 * random_vector(cold.force.size(), random)};
      const ContactSolution<3> misled = problem.solve(settings);
      EXPECT_EQ(misled.multigrid, Multigrid::used);
      EXPECT_LE(max_norm(misled.force - cold.force),
                1e-9 * max_norm(cold.force));
    }
  }
}

TEST(MultigridRelation, has_it_of_solids_whose_meshes_do_not_match) {
  for (const double stiffness : {1e-3, 1.0, 10.0})
    for (const double mu : {0.0, 0.3, 1.0})
      expect_same(block_on_a_block(mu, stiffness).problem);
}

RC_GTEST_PROP(MultigridRelation, has_the_answer_of_a_factor_of_random_solids,
              (Random random)) {
  const SolidProblem problem = random_solids(0.3, random).problem;
  const ContactSolution<3> other = problem.solve(by(LinearSolver::direct));
  RC_PRE(other.accepted({}));
  ContactSettings from_0;
  from_0.multigrid_from = 0;
  const ContactSolution<3> one = problem.solve(from_0);
  RC_TAG(one.multigrid == Multigrid::used);
  RC_ASSERT(one.accepted({}));
  RC_ASSERT(max_norm(one.force - other.force) <= 1e-7 * max_norm(other.force));
}

TEST(MultigridRelation, has_it_in_any_units) {
  for (const double unit : {1e-9, 1e9}) {
    SolidProblem problem =
        block_problem(brick({8, 4, 4}, {80, 40, 40}), BlockCase::press_x, 0.5);
    const ContactSolution<3> in_mm = problem.solve(by(LinearSolver::multigrid));
    for (Index k = 0; k < problem.A.nonZeros(); ++k)
      if (problem.A.valuePtr()[k] != 1e30) problem.A.valuePtr()[k] *= unit;
    problem.b *= unit;
    const ContactSolution<3> scaled =
        problem.solve(by(LinearSolver::multigrid));
    ASSERT_EQ(scaled.multigrid, Multigrid::used);
    EXPECT_LE(max_norm(scaled.force / unit - in_mm.force),
              1e-8 * max_norm(in_mm.force));
  }
}

/// Whatever is drawn, where multigrid does not get there a factor does.
RC_GTEST_PROP(MultigridRelation, has_the_answer_of_a_factor_of_rough_problems,
              (Random random)) {
  SolidProblem problem = rough_problem(random);
  problem.law.friction *= 0.3;  // one solution
  if (random() % 2 == 0) {
    problem.law.slip_bound = 10 * problem.law.friction;
    problem.law.friction.setZero();
  }
  const ContactSolution<3> one = problem.solve(by(LinearSolver::multigrid)),
                           other = problem.solve(by(LinearSolver::direct));
  RC_ASSERT(one.accepted({}));
  RC_ASSERT(other.accepted({}));
  RC_ASSERT(max_norm(one.force - other.force) <= 1e-7 * max_norm(other.force));
}

TEST(MultigridRelation, has_the_same_digits_on_two_threads) {
  const SolidProblem problem =
      block_problem(brick({8, 4, 4}, {80, 40, 40}), BlockCase::press_x, 0.5);
  const auto answer = [&] {
    return problem.solve(by(LinearSolver::multigrid)).displacement;
  };
  EXPECT_EQ(on_threads(1, answer), on_threads(2, answer));
}

}  // namespace
}  // namespace ffcontact
