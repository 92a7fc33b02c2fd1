// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/rigid_tool.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/contact/law/nodal_law.hpp"
#include "support/cases.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Free along x, along y and about a point.
RigidTool free_tool(const Vector2d& about, const Vector3d& push) {
  return {about, Matrix3d::Identity(), push};
}

/// Force and moment about a point of the contact forces on the body.
Vector3d resultant(const Problem& problem, const RigidTool& tool,
                   const ContactSolution<2>& solution) {
  Vector3d sum;
  for (int k = 0; k < 3; ++k)
    sum[k] =
        tool_components(problem.mesh, problem.line, tool, Vector3d::Unit(k))
            .cwiseProduct(solution.force)
            .sum();
  return sum;
}

ContactSolution<2> with_prescribed(Problem problem, const RigidTool& tool,
                                   const Vector3d& motion) {
  const Matrix2Xd z = tool_components(problem.mesh, problem.line, tool, motion);
  problem.law.gap = z.row(0);
  problem.law.previous = z.row(1);
  return solved(problem);
}

ToolSolution pushed(const Problem& problem, const RigidTool& tool,
                    const ContactSettings& settings = {}) {
  return solve_contact_with_tool(problem.mesh, problem.line, problem.law,
                                 problem.system(), tool, settings);
}

/// A block that is clamped at its top, on a tool.
Problem clamped_block(const Mesh& mesh, double mu, Multiplier multiplier) {
  Problem problem = body(mesh, material(1000, 0.3));
  clamp(problem, top);
  set_friction(problem, mu);
  problem.law.multiplier = multiplier;
  return problem;
}

/// What a prescribed motion needs in force and moment brings about that motion.
RC_GTEST_PROP(RigidTool, moves_as_a_prescribed_motion_with_its_forces,
              (Random random)) {
  const Mesh mesh =
      irregular(*rc::gen::inRange(3, 9), *rc::gen::inRange(2, 6), 6, 4, random);
  const Problem problem =
      clamped_block(mesh, *rc::gen::element(0.0, 0.3, 0.8),
                    *rc::gen::element(Multiplier::force, Multiplier::pressure));
  RigidTool tool = free_tool(random_vector(2, random) * 5, {0, 0, 0});
  const double scale = std::pow(10.0, *real(-6, 0));
  const Vector3d motion =
      scale * (Vector3d(0, 0.05, 0) +
               random_vector(3, random).cwiseProduct(Vector3d(.005, .02, .02)));
  const ContactSolution<2> prescribed = with_prescribed(problem, tool, motion);
  RC_PRE(prescribed.status == ContactStatus::converged);
  tool.push = resultant(problem, tool, prescribed);
  RC_PRE(tool.push.norm() > 0);
  int stick = 0;
  for (const ContactState state : prescribed.state)
    stick += state == ContactState::stick;
  // else it may go on sliding under the same forces
  if (problem.law.friction[0] == 0)
    tool.free = Matrix3d::Identity().rightCols(2);
  RC_PRE(problem.law.friction[0] == 0 || stick > 1);

  const ToolSolution solution = pushed(problem, tool);
  RC_ASSERT(solution.solution.status == ContactStatus::converged);
  RC_ASSERT(solution.imbalance <= 1e-10);
  RC_ASSERT((resultant(problem, tool, solution.solution) - tool.push)
                .tail(tool.free.cols())
                .norm() <= 1e-9 * tool.push.norm());
  // without friction there is one solution; with it the same in most cases
  if (problem.law.friction[0] > 0.3) return;
  RC_ASSERT(relative_difference(solution.solution.displacement,
                                prescribed.displacement) < 1e-6);
}

/// A uniform bar of height h and width w: p h / E' deep, and no tilt.
TEST(RigidTool, presses_a_bar_uniformly) {
  for (Multiplier multiplier : both_multipliers) {
    Random random(3);
    Problem problem = body(irregular(6, 4, 6, 4, random), material(1000, 0.3));
    prescribe(problem, top, 1);
    prescribe(problem, left, 0);
    problem.law.multiplier = multiplier;
    RigidTool tool = free_tool({3, -1}, {0, 12, 0});
    tool.free = Matrix3d::Identity().rightCols(2);
    const ToolSolution solution = pushed(problem, tool);
    EXPECT_EQ(solution.solution.status, ContactStatus::converged);
    const double deep = 2.0 * 4 * (1 - 0.3 * 0.3) / 1000;
    EXPECT_NEAR(solution.motion[1], deep, 1e-10 * deep);
    EXPECT_NEAR(solution.motion[2], 0, 1e-12 * deep);
    EXPECT_EQ(solution.motion[0], 0);
    for (const double p : solution.solution.pressure.row(0))
      EXPECT_NEAR(p, -2, 1e-9);
  }
}

/// By its line of action alone: a force off the point is a force with a moment.
TEST(RigidTool, knows_the_line_of_action_of_its_force) {
  Random random(8);
  const Problem problem =
      clamped_block(irregular(7, 4, 6, 4, random), 0.4, Multiplier::force);
  const RigidTool at_middle = free_tool({3, 0}, {1, 10, 4});
  // the moment about another point c': M - (c' - c) x F
  const RigidTool elsewhere =
      free_tool({5, 2}, {1, 10, 4 - (2 * 10.0 - 2 * 1.0)});
  const ToolSolution one = pushed(problem, at_middle),
                     other = pushed(problem, elsewhere);
  EXPECT_EQ(one.solution.status, ContactStatus::converged);
  EXPECT_LT(relative_difference(other.solution.displacement,
                                one.solution.displacement),
            1e-9);
  // turned about another point by the same angle
  EXPECT_NEAR(other.motion[2], one.motion[2], 1e-9 * std::abs(one.motion[2]));
  const Vector2d at_other =
      one.motion.head<2>() + one.motion[2] * Vector2d(-2, 2);
  EXPECT_LT((other.motion.head<2>() - at_other).norm(),
            1e-9 * one.motion.norm());
}

/// A guide takes what it does not leave free.
TEST(RigidTool, moves_along_its_guide_alone) {
  const Problem problem =
      clamped_block(rectangle(6, 4, 6, 4), 0.5, Multiplier::force);
  RigidTool tool = free_tool({3, 0}, {7, 10, 100});
  tool.free = Vector3d(0, 1, 0);
  const ToolSolution solution = pushed(problem, tool);
  EXPECT_EQ(solution.solution.status, ContactStatus::converged);
  EXPECT_EQ(solution.motion[0], 0);
  EXPECT_EQ(solution.motion[2], 0);
  EXPECT_NEAR(resultant(problem, tool, solution.solution)[1], 10, 1e-9);
}

/// A body that contact alone holds between its load and the tool.
TEST(RigidTool, carries_a_body_that_nothing_else_holds) {
  Problem problem = body(rectangle(6, 4, 6, 4), material(1000, 0.3));
  add_traction(problem, top, {0, -2});
  prescribe(problem, left, 0);
  RigidTool tool = free_tool({3, 0}, {0, 12, 0});
  tool.free = Vector3d(0, 0, 1);
  const ToolSolution solution = pushed(problem, tool);
  EXPECT_EQ(solution.solution.status, ContactStatus::converged);
  EXPECT_NEAR(resultant(problem, tool, solution.solution)[1], 12, 1e-9);
}

TEST(RigidTool, that_no_contact_forces_balance_is_refused) {
  const Problem problem =
      clamped_block(rectangle(6, 4, 6, 4), 0.3, Multiplier::force);
  const auto refusal_of = [&](const Vector3d& push) {
    return refusal([&] { pushed(problem, free_tool({3, 0}, push)); });
  };
  EXPECT_EQ(refusal_of({0, 10, 0}), "accepted");
  EXPECT_EQ(refusal_of({2.9, 10, 0}), "accepted");
  // drawn away, slides, tips over
  for (const Vector3d& push :
       {Vector3d(0, -10, 0), Vector3d(3.1, 10, 0), Vector3d(0, 10, 31)})
    EXPECT_TRUE(says(refusal_of(push), "no contact forces in the cone"));
  RigidTool tool = free_tool({3, 0}, {0, 10, 0});
  tool.free.resize(3, 0);
  EXPECT_TRUE(says(refusal([&] { pushed(problem, tool); }), "no free motion"));
}

/// A tool that is already where its push leaves it stays there, with its states.
TEST(RigidTool, needs_few_iterations_from_its_states) {
  const Problem problem =
      clamped_block(rectangle(12, 8, 6, 4), 0.3, Multiplier::force);
  const RigidTool tool = free_tool({3, 0}, {1, 10, 5});
  const ToolSolution first = pushed(problem, tool);
  ContactSettings settings;
  settings.initial_state = first.solution.state;
  settings.stiffness = first.solution.stiffness;
  const ToolSolution again = pushed(problem, tool, settings);
  EXPECT_EQ(again.solution.state, first.solution.state);
  EXPECT_LE(again.solution.iterations, 4);
  EXPECT_LT((again.motion - first.motion).norm(), 1e-10 * first.motion.norm());
}

}  // namespace
}  // namespace ffcontact
