// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "ffcontact/contact/multigrid/surface_unknowns.hpp"
#include "support/pressed_bricks.hpp"
#include "support/refusals.hpp"
#include "support/solid_corners.hpp"
#include "support/threads.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

SolidProblem coarse_block(int walls, double mu) {
  return block_in_a_corner(brick({8, 4, 4}, {80, 40, 40}), walls, mu);
}

TEST(MultigridEdges, have_the_answer_of_a_factor) {
  for (const int walls : {1, 2})
    for (const double mu : {0.0, 0.3, 1.0})
      expect_same_but_shares(coarse_block(walls, mu));
}

TEST(MultigridEdges, have_all_of_it_without_friction) {
  for (const int walls : {1, 2}) expect_same(coarse_block(walls, 0));
}

TEST(MultigridEdges, have_it_of_a_body_that_is_moved_from_a_wall) {
  for (const int walls : {1, 2})
    for (const double mu : {0.0, 0.3, 1.0}) {
      SolidProblem problem(brick({8, 4, 4}, {80, 40, 40}), mu,
                           walls == 1 ? std::vector<int>{low_z, low_x}
                                      : std::vector<int>{low_z, low_x, low_y});
      problem.move(high_z, [](const Vector3d& x) {
        return Vector3d(0.002, 0.001, -0.03 + 4e-4 * x.x());
      });
      problem.load(high_x, {-10, 0, 0});
      expect_same_but_shares(problem);
    }
}

TEST(MultigridEdges, have_it_along_directions_that_turn) {
  Random random(1);
  for (const int walls : {1, 2}) {
    SolidProblem problem = coarse_block(walls, 0.3);
    problem.surface = turned_at_random(problem.surface, 0.2, random);
    expect_same_but_shares(problem);
  }
}

TEST(MultigridEdges, have_it_of_a_load_step_and_gaps) {
  Random random(1);
  for (const int walls : {1, 2}) {
    SolidProblem problem = coarse_block(walls, 0.3);
    const int nodes = problem.surface.node_count();
    problem.law.previous = 1e-3 * random_matrix(2, nodes, random);
    problem.law.gap = 1e-3 * random_vector(nodes, random).cwiseAbs();
    expect_same_but_shares(problem);
  }
}

TEST(MultigridEdges, have_it_where_friction_has_a_bound) {
  for (const int walls : {1, 2})
    for (const double bound : {0.1, 1.0}) {
      SolidProblem problem = coarse_block(walls, 0);
      problem.law.slip_bound =
          VectorXd::Constant(problem.surface.node_count(), bound);
      expect_same_but_shares(problem);
    }
}

TEST(MultigridEdges, have_it_of_solids_where_friction_has_a_bound) {
  Random random(1);
  for (const double bound : {0.1, 1.0}) {
    SolidCorner corner(2, 0, random, 4);
    SolidProblem& problem = corner.problem;
    problem.law.slip_bound =
        VectorXd::Constant(problem.surface.node_count(), bound);
    expect_same_but_shares(problem);
  }
}

TEST(MultigridEdges, have_it_with_a_layer) {
  for (const int walls : {1, 2})
    for (const double c : {1e-7, 1e-5, 1e-3, 1e-1})
      for (const CompliantLayer& layer :
           {CompliantLayer{c, 0}, CompliantLayer{0, c},
            CompliantLayer{c, 2 * c}}) {
        SolidProblem problem = coarse_block(walls, 0.3);
        problem.law.layer = layer;
        expect_same_but_shares(problem);
      }
}

TEST(MultigridEdges, have_it_of_solids_whose_meshes_do_not_match) {
  Random random(1);
  for (const int walls : {1, 2})
    for (const double mu : {0.0, 0.3, 1.0})
      expect_same_but_shares(SolidCorner(walls, mu, random).problem);
}

/// Where the edge sticks to one of the bodies and slides on another.
TEST(MultigridEdges, have_it_of_bodies_with_different_friction) {
  Random random(1);
  SolidCorner corner(1, 0, random, 4);
  SolidProblem& problem = corner.problem;
  for (const int rough : {0, 1}) {
    for (int i = 0; i < problem.surface.node_count(); ++i) {
      const bool on_wall = std::abs(problem.surface.normal(0, i)) > 0.5;
      problem.law.friction[i] = on_wall == (rough == 1) ? 1 : 0.1;
    }
    expect_same_but_shares(problem);
  }
}

TEST(MultigridEdges, have_it_of_supports_that_face_what_moves) {
  for (const double mu : {0.0, 0.3, 1.0})
    expect_same_but_shares(brick_with_a_moved_side(mu, 1).problem);
}

TEST(MultigridEdges, start_from_rows_that_are_near) {
  for (const int walls : {1, 2}) {
    const ColdAndWarm found(coarse_block(walls, 0.3));
    EXPECT_LT(found.warm.iterations, found.cold.iterations);
  }
}

/// Of a brick that fills the corner of an L, as one mesh cut in two: both nodes of the
/// vertices on its edge face the same vertex.
TEST(MultigridEdges, have_it_of_meshes_that_match) {
  for (const double mu : {0.0, 0.3}) {
    const SolidCorner corner = SolidCorner::of_matching_meshes(mu);
    expect_same_but_shares(corner.problem);
  }
}

TEST(MultigridEdges, need_few_systems) {
  const SolidMesh mesh = brick({24, 12, 12}, {80, 40, 40});
  for (const double mu : {0.0, 0.5}) {
    const int without = block_in_a_corner(mesh, 0, mu)
                            .solve(by(LinearSolver::multigrid))
                            .iterations;
    for (const int walls : {1, 2})
      EXPECT_LE(block_in_a_corner(mesh, walls, mu)
                    .solve(by(LinearSolver::multigrid))
                    .iterations,
                without + 3);
  }
}

TEST(MultigridEdges, have_the_same_digits_on_two_threads) {
  const SolidProblem problem = coarse_block(2, 0.3);
  const auto answer = [&] {
    return problem.solve(by(LinearSolver::multigrid)).displacement;
  };
  EXPECT_EQ(on_threads(1, answer), on_threads(2, answer));
}

/// Of a brick on another one, both beside a third one, which the second one's edge is on.
TEST(MultigridEdges, are_left_to_a_factor_where_they_are_faced) {
  Random random(1);
  SolidCorner corner(1, 0.3, random);
  SolidProblem& problem = corner.problem;
  const FacingSurface beside =
      facing(problem.mesh, problem.faces, corner.label(2, low_z),
             corner.label(1, high_z));
  problem.surface = joined_contact<3>({problem.surface, beside.surface});
  const int nodes = problem.surface.node_count();
  problem.law.gap.conservativeResize(nodes);
  problem.law.gap.tail(beside.gap.size()).setZero();
  problem.law.friction.setConstant(nodes, 0.3);
  EXPECT_EQ(refusal([&] { problem.solve(by(LinearSolver::multigrid)); }),
            "solver=\"multigrid\" is for solids whose contact vertices do not "
            "face each other: leave it out");
  ContactSettings from_0;
  from_0.multigrid_from = 0;
  const ContactSolution<3> found = problem.solve(from_0);
  EXPECT_TRUE(found.accepted({}));
  EXPECT_EQ(found.multigrid, Multigrid::unused);
}

RC_GTEST_PROP(MultigridEdges, have_the_answer_of_a_factor_of_random_solids,
              (Random random)) {
  const SolidCorner corner(1 + random() % 2, 0.3 * (random() % 2), random);
  const SolidProblem& problem = corner.problem;
  const ContactSolution<3> one = problem.solve(by(LinearSolver::multigrid)),
                           other = problem.solve(by(LinearSolver::direct));
  RC_TAG(one.multigrid == Multigrid::used);
  RC_ASSERT(one.accepted({}));
  RC_ASSERT(max_norm(one.displacement - other.displacement) <=
            1e-7 * max_norm(other.displacement));
}

RC_GTEST_PROP(MultigridEdges, have_it_of_rough_problems, (Random random)) {
  SolidProblem problem =
      block_in_a_corner(irregular_solid(random), 1 + random() % 2, 0);
  make_rough(problem, random);
  problem.law.friction *= 0.3;  // one solution
  const ContactSolution<3> one = problem.solve(by(LinearSolver::multigrid)),
                           other = problem.solve(by(LinearSolver::direct));
  RC_TAG(one.multigrid == Multigrid::used);
  RC_ASSERT(one.accepted({}));
  RC_ASSERT(other.accepted({}));
  RC_ASSERT(max_norm(one.displacement - other.displacement) <=
            1e-7 * max_norm(other.displacement));
}

}  // namespace
}  // namespace ffcontact
