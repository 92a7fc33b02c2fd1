// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/balance.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/checks/line_balance.hpp"
#include "support/problems.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A block 4 x 2 that stands on the foundation, pressed by 1 MPa from the top, without
/// any support.
Problem standing_block(double mu) {
  Problem problem = body(rectangle(8, 4, 4, 2), material(100, 0.3));
  add_traction(problem, top, {0, -1});
  set_friction(problem, mu);
  return problem;
}

std::string refusal_by_balance(const Problem& problem) {
  return refusal([&] {
    require_balance(problem.mesh, problem.line, problem.law, problem.system());
  });
}

std::string no_equilibrium(const std::string& motion) {
  return "no equilibrium: the loads push the body in a " + motion +
         ", which neither prescribed displacements nor contact forces oppose";
}

TEST(Balance, a_pressed_block_is_held) {
  EXPECT_EQ(refusal_by_balance(standing_block(0)), "accepted");
}

TEST(Balance, a_lifted_block_is_refused) {
  Problem problem = example_2(Multiplier::force, 0.3, 4);
  add_traction(problem, top, {0, 6});
  EXPECT_EQ(refusal_by_balance(problem),
            no_equilibrium("translation along (0, 1)"));
}

TEST(Balance,
     pushed_sideways_a_block_is_held_up_to_the_friction_of_its_weight) {
  Problem problem =
      standing_block(0.5);  // 4 N/mm down, 2 N/mm of friction at most
  add_body_force(problem, {1.99 / 8, 0});
  EXPECT_EQ(refusal_by_balance(problem), "accepted");
  add_body_force(problem, {0.02 / 8, 0});
  EXPECT_EQ(refusal_by_balance(problem),
            "no equilibrium: the loads push the body in a translation along "
            "(1, 0) with 2.01 N/mm, against which contact has 2 N/mm at most");
}

TEST(Balance, whatever_its_friction_a_rough_block_is_held) {
  for (const double mu : {1.0, 1e4, 1e8, 1e30}) {
    Problem problem = standing_block(mu);
    add_body_force(problem, {0.3, 0});
    EXPECT_EQ(refusal_by_balance(problem), "accepted") << mu;
    add_traction(problem, top, {0, 1.5});
    EXPECT_NE(refusal_by_balance(problem), "accepted") << mu;
  }
}

TEST(Balance, without_friction_a_push_sideways_is_refused) {
  Problem problem = standing_block(0);
  add_body_force(problem, {0.1, 0});
  EXPECT_EQ(refusal_by_balance(problem),
            no_equilibrium("translation along (1, 0)"));
}

TEST(Balance, a_block_that_tips_over_is_refused_with_its_rotation) {
  Problem problem = body(rectangle(8, 4, 4, 2), material(100, 0.3));
  add_body_force(problem, {0, -1});  // 8 N/mm in the middle
  set_friction(problem, 10);
  // 10 N/mm at the height 1: moment 10 against 16 about the corner (4, 0)
  add_traction(problem, left, {5, 0});
  EXPECT_EQ(refusal_by_balance(problem), "accepted");
  add_traction(problem, left, {5, 0});
  EXPECT_EQ(refusal_by_balance(problem),
            no_equilibrium("rotation about (4, 0)"));
}

/// The same motions where the line is inclined: the sentence speaks of the line's own
/// directions.
TEST(Balance, names_the_slope_that_a_block_slides_down) {
  const double c = 0.8, s = 0.6;
  Mesh mesh = rectangle(8, 4, 4, 2);
  const Matrix2d turn = (Matrix2d() << c, -s, s, c).finished();
  mesh.vertices = turn * mesh.vertices;
  Problem problem = body(mesh, material(100, 0.3));
  add_body_force(problem, {0, -1});  // 8 N/mm, 4.8 along the slope, 6.4 across
  set_friction(problem, 0.76);
  EXPECT_EQ(refusal_by_balance(problem), "accepted");
  set_friction(problem, 0.5);
  EXPECT_EQ(refusal_by_balance(problem),
            "no equilibrium: the loads push the body in a translation along "
            "(-0.8, -0.6) with 4.8 N/mm, against which contact has 3.2 N/mm at "
            "most");
}

/// Without weight nothing but a pull sideways in the middle, through the centre.
TEST(Balance, friction_without_a_normal_force_holds_nothing) {
  Problem problem = body(rectangle(8, 4, 4, 2), material(100, 0.3));
  set_friction(problem, 0.5);
  add_body_force(problem, {-0.1, 0});
  EXPECT_EQ(refusal_by_balance(problem),
            no_equilibrium("translation along (-1, 0)"));
}

TEST(Balance, with_tresca_a_bounded_force_is_no_reason_to_refuse) {
  Problem problem = standing_block(0);
  problem.law.slip_bound = everywhere(problem.line, 1);
  add_body_force(problem, {0.1, 0});
  EXPECT_EQ(refusal_by_balance(problem), "accepted");
  problem.law.slip_bound.setZero();
  EXPECT_TRUE(says(refusal_by_balance(problem), "no equilibrium"));
}

TEST(Balance, a_spring_holds_a_body_as_a_support_does) {
  Problem problem = standing_block(0);
  add_body_force(problem, {0.1, 0});
  EXPECT_EQ(unheld_motions(problem.mesh, problem.system()).cols(), 3);
  problem.A.coeffRef(0, 0) += 1;  // along x
  EXPECT_EQ(unheld_motions(problem.mesh, problem.system()).cols(), 2);
  EXPECT_EQ(refusal_by_balance(problem), "accepted");
}

TEST(Balance, loads_on_a_body_that_supports_hold_are_never_refused) {
  Problem problem = example_1(Multiplier::force, 4);
  add_traction(problem, left, {0, 1e6});
  EXPECT_EQ(refusal_by_balance(problem), "accepted");
}

}  // namespace
}  // namespace ffcontact
