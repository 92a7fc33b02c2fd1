// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/feasibility.hpp"

#include <gtest/gtest.h>

#include "support/bodies.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

std::string refusal_by_feasibility(const Problem& problem) {
  return refusal([&] {
    require_feasible(problem.mesh, problem.line, problem.law, problem.system());
  });
}

/// A block 4 x 2 whose right side is prescribed to move by `value`.
Problem supported_block(const Vector2d& value) {
  Problem problem = body(rectangle(4, 2, 4, 2), material(100, 0.3));
  clamp(problem, right, [&](const Vector2d&) { return value; });
  return problem;
}

void set_direction(Problem& problem, const Vector2d& n) {
  const ContactLine line =
      smooth_contact_line(problem.mesh, problem.edges, {bottom});
  problem.line = along_directions(problem.mesh, problem.edges, line,
                                  n.replicate(1, line.node_count()));
}

TEST(Feasibility,
     a_support_that_pushes_its_end_of_the_line_into_the_foundation_is_refused) {
  EXPECT_EQ(refusal_by_feasibility(supported_block({0.5, -0.01})),
            "prescribed displacements hold vertex 4 at (4, 0) 0.01 inside the "
            "foundation: change them or gap= there, "
            "or free a "
            "dof that moves it along n");
}

TEST(Feasibility, both_multipliers_refuse) {
  Problem problem = supported_block({0, -0.01});
  for (Multiplier multiplier : {Multiplier::force, Multiplier::pressure}) {
    problem.law.multiplier = multiplier;
    EXPECT_TRUE(says(refusal([&] { solved(problem); }),
                     "prescribed displacements hold vertex 4"))
        << int(multiplier);
  }
}

TEST(Feasibility, the_gap_counts) {
  Problem problem = supported_block({0, -0.01});
  problem.law.gap = everywhere(problem.line, 0.01);
  EXPECT_EQ(refusal_by_feasibility(problem), "accepted");
  problem.law.gap = everywhere(problem.line, 0.009);
  EXPECT_TRUE(
      says(refusal_by_feasibility(problem), "vertex 4 at (4, 0) 0.001 inside"));
}

TEST(Feasibility, an_interference_that_free_nodes_can_follow_is_accepted) {
  Problem problem = body(rectangle(4, 2, 4, 2), material(100, 0.3));
  prescribe(problem, right, 0);
  clamp(problem, top);
  problem.law.gap = everywhere(problem.line, -0.001);
  EXPECT_EQ(refusal_by_feasibility(problem), "accepted");
  prescribe(problem, bottom, 1);
  EXPECT_TRUE(
      says(refusal_by_feasibility(problem), " 0.001 inside the foundation"));
}

TEST(Feasibility, what_rounding_leaves_of_a_touching_support_is_accepted) {
  for (double scale : {1e-6, 1.0, 1e6}) {
    Problem problem =
        body(rectangle(4, 2, 4 * scale, 2 * scale), material(100, 0.3));
    clamp(problem, right,
          [&](const Vector2d&) { return Vector2d(0, -0.1 * scale); });
    problem.law.gap = everywhere(problem.line, 0.1 * scale * (1 - 1e-13));
    EXPECT_EQ(refusal_by_feasibility(problem), "accepted") << scale;
  }
}

TEST(Feasibility, along_an_oblique_direction_one_free_component_is_enough) {
  Problem problem = body(rectangle(4, 2, 4, 2), material(100, 0.3));
  prescribe(problem, right, 1,
            [](const Vector2d&) { return Vector2d(0, -0.01); });
  EXPECT_TRUE(says(refusal_by_feasibility(problem), "vertex 4"));
  set_direction(problem, {0.5, -1});
  EXPECT_EQ(refusal_by_feasibility(problem), "accepted");
  // it would have to slide 1000 to leave the foundation
  set_direction(problem, {1e-5, -1});
  EXPECT_TRUE(says(refusal_by_feasibility(problem), "vertex 4"));
  set_direction(problem, {0.5, -1});
  prescribe(problem, right, 0);
  EXPECT_TRUE(says(refusal_by_feasibility(problem), "vertex 4"));
}

/// A tip that points along x between two walls, free to move along y alone.
Problem tip_in_a_groove(double lower_gap, double upper_gap) {
  Problem problem =
      body(triangle({0, -1}, {2, 0}, {0, 1}, {bottom, bottom, left}),
           material(100, 0.3));
  prescribe_dof(problem, 2, 0);
  problem.law.gap = everywhere(problem.line, 1);
  for (int i = 0; i < problem.line.node_count(); ++i)
    if (problem.line.vertex[i] == 1)
      problem.law.gap[i] =
          problem.line.normal(1, i) < 0 ? lower_gap : upper_gap;
  return problem;
}

TEST(Feasibility, two_walls_that_a_vertex_cannot_leave_together_are_refused) {
  EXPECT_EQ(refusal_by_feasibility(tip_in_a_groove(-0.1, 0.2)), "accepted");
  EXPECT_TRUE(says(refusal_by_feasibility(tip_in_a_groove(-0.2, 0.1)),
                   "vertex 1 at (2, 0) 0.2 inside the foundation"));
}

/// Two blocks on each other; the right side of the upper one moves down by 0.01, that of
/// the lower one is held in `held` components.
Bodies blocks(int upper, int lower, int held) {
  Bodies two = bodies(
      {shifted(rectangle(upper, 2, 4, 2), {0, 2}), rectangle(lower, 2, 4, 2)},
      {material(100, 0.3), material(100, 0.3)}, {{0, bottom, 1, top}});
  clamp(two.problem, two.label(0, right),
        [](const Vector2d&) { return Vector2d(0, -0.01); });
  for (int component = 0; component < held; ++component)
    prescribe(two.problem, two.label(1, right), component);
  return two;
}

TEST(Feasibility, supports_of_both_bodies_are_taken_together) {
  for (const auto& [upper, lower] :
       {std::pair(4, 4), std::pair(4, 3), std::pair(3, 7)}) {
    EXPECT_EQ(refusal_by_feasibility(blocks(upper, lower, 0).problem),
              "accepted");
    EXPECT_EQ(refusal_by_feasibility(blocks(upper, lower, 1).problem),
              "accepted");
    EXPECT_TRUE(says(refusal_by_feasibility(blocks(upper, lower, 2).problem),
                     " at (4, 2) 0.01 inside the opposite body"))
        << upper << " : " << lower << ": "
        << refusal_by_feasibility(blocks(upper, lower, 2).problem);
  }
}

TEST(Feasibility, a_vertex_between_nodes_of_the_other_body_is_seen) {
  Bodies two =
      bodies({shifted(rectangle(1, 1, 4, 2), {0, 2}), rectangle(2, 1, 4, 2)},
             {material(100, 0.3), material(100, 0.3)}, {{0, bottom, 1, top}});
  Problem& problem = two.problem;
  clamp(problem, two.label(0, bottom));
  EXPECT_EQ(refusal_by_feasibility(problem), "accepted");
  // the middle of the lower body's top bulges
  for (int v = 0; v < problem.mesh.vertex_count(); ++v)
    if (v >= two.joined.first_vertex[1] &&
        problem.mesh.vertices.col(v) == Vector2d(2, 2))
      prescribe_dof(problem, 2 * v + 1, 0.02);
  EXPECT_TRUE(says(refusal_by_feasibility(problem),
                   " at (2, 2) 0.02 inside the opposite body"));
}

TEST(Feasibility, a_tool_with_a_prescribed_line_presses_a_free_body) {
  for (const auto& [upper, lower] : {std::pair(6, 6), std::pair(5, 8)}) {
    Bodies two = bodies(
        {shifted(rectangle(upper, 1, 4, 2), {0, 2}), rectangle(lower, 2, 4, 2)},
        {material(100, 0.3), material(100, 0.3)}, {{0, bottom, 1, top}});
    prescribe(two.problem, two.label(0, bottom), 1,
              [](const Vector2d&) { return Vector2d(0, -0.01); });
    clamp(two.problem, two.label(1, bottom));
    prescribe(two.problem, two.label(1, left), 0);
    EXPECT_EQ(refusal_by_feasibility(two.problem), "accepted");
  }
}

}  // namespace
}  // namespace ffcontact
