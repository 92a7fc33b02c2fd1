// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/carrying_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/solid_estimates.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr double step_at = 3.5;

/// A brick pushed down and along a plane that is so much lower beyond x = 3.5 mm.
SolidProblem on_a_step(double depth) {
  SolidProblem problem(brick({8, 3, 2}, {8, 3, 2}), 0.4);
  problem.move(high_z, [](const Vector3d&) { return Vector3d(0, 0, -1e-3); });
  problem.load(high_x, {1, 0, 0});
  const VectorXi& vertex = problem.surface.vertex;
  problem.law.gap = VectorXd::NullaryExpr(vertex.size(), [&](Index i) {
    return problem.mesh.vertices(0, vertex[i]) < step_at ? 0.0 : depth;
  });
  return problem;
}

struct Carried {
  SolidProblem problem;
  Matrix3Xd lumped;
  CarryingNodes nodes;
};

Carried carried(SolidProblem problem) {
  const auto topology = topology_of(problem.mesh);
  const auto system = problem.system();
  const SolvedBody<3> body = solved_solid(problem, problem.solve());
  const SolvedProblem<3> solved{topology, problem.surface, system, body};
  const Matrix3Xd lumped =
      lumped_tractions(problem.law, problem.surface, body.multipliers);
  CarryingNodes nodes =
      carrying_nodes(MatchedBodies<3>(solved), body.displacement, lumped);
  return {std::move(problem), lumped, std::move(nodes)};
}

Carried carried_on_a_step(double depth) { return carried(on_a_step(depth)); }

TEST(CarryingNodes, hand_their_forces_to_the_closed_faces) {
  const auto [problem, lumped, nodes] = carried_on_a_step(1);
  const ContactSurface& surface = problem.surface;
  double moved = 0;
  for (int i = 0; i < surface.node_count(); ++i) {
    const double x = problem.mesh.vertices(0, surface.vertex[i]);
    EXPECT_EQ(nodes.carries[i], x < step_at - 1) << x;
    if (x > step_at - 1) moved += nodes.traction.col(i).norm();
  }
  EXPECT_EQ(moved, 0);
  const double pressed = surface.area.dot(lumped.row(0));
  EXPECT_LT(pressed, -1);
  EXPECT_NEAR(surface.area.dot(nodes.traction.row(0)), pressed,
              1e-12 * std::abs(pressed));
  EXPECT_LT(cone_violation(problem.law, nodes.traction), 1e-12);
}

TEST(CarryingNodes, are_all_where_little_opens) {
  const auto [problem, lumped, nodes] = carried_on_a_step(1.3e-3);
  EXPECT_EQ(count_of(nodes.carries), problem.surface.node_count());
  for (const char carries : nodes.carries) EXPECT_TRUE(carries);
  EXPECT_LT((nodes.traction - lumped).norm(), 1e-14 * lumped.norm());
}

TEST(CarryingNodes, keep_what_no_closed_face_takes) {
  // the lowest corner alone touches
  SolidProblem problem(brick({3, 3, 2}, {3, 3, 2}), 0.4);
  problem.move(high_z, [](const Vector3d&) { return Vector3d(0, 0, -1e-3); });
  const VectorXi& vertex = problem.surface.vertex;
  problem.law.gap = VectorXd::NullaryExpr(vertex.size(), [&](Index i) {
    return problem.mesh.vertices.col(vertex[i]).head<2>().norm();
  });
  const auto [solved, lumped, nodes] = carried(std::move(problem));
  EXPECT_EQ(nodes.traction, lumped);
  EXPECT_EQ(std::count(nodes.carries.begin(), nodes.carries.end(), 1), 1);
}

TEST(CarryingNodes, keep_friction_that_asks_for_no_contact) {
  SolidProblem step = on_a_step(1);
  step.law.friction.setZero();
  step.law.slip_bound = VectorXd::Constant(step.surface.node_count(), 0.5);
  const auto [problem, lumped, nodes] = carried(std::move(step));
  int open = 0;
  double friction = 0;
  for (int i = 0; i < problem.surface.node_count(); ++i) {
    if (nodes.carries[i]) continue;
    ++open;
    EXPECT_EQ(nodes.traction(0, i), 0);
    EXPECT_EQ(nodes.traction.col(i).tail<2>(), lumped.col(i).tail<2>());
    friction += lumped.col(i).tail<2>().norm();
  }
  EXPECT_GT(friction, 0.2 * open);
  EXPECT_LT(nodes.traction.row(0).minCoeff(), lumped.row(0).minCoeff());
}

TEST(CarryingNodes, make_e_independent_of_how_deep_a_step_is) {
  const double shallow = estimate(on_a_step(0.01)).e,
               deep = estimate(on_a_step(1)).e,
               abyss = estimate(on_a_step(1e4)).e;
  EXPECT_NEAR(deep, abyss, 1e-6 * deep);
  EXPECT_NEAR(shallow, abyss, 1e-3 * abyss);
}

}  // namespace
}  // namespace ffcontact
