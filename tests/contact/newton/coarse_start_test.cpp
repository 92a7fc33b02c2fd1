// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/coarse_start.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "support/condensed_blocks.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The condensed relation of a problem and its law.
struct Relation : CondensedProblem {
  const SolidProblem& problem;
  NodalLaw law;

  explicit Relation(const SolidProblem& stated)
      : CondensedProblem(stated),
        problem(stated),
        law(nodal_law(problem.law, problem.surface)) {}

  std::optional<ContactRows> start() const {
    return coarse_start(contact, law, problem.surface);
  }
  ActiveSetResult from(const ContactRows& near) const {
    StepSolver solver;
    return surface_newton(contact, law, trace.held, near, solver);
  }
  ActiveSetResult from_sticking() const {
    return surface_newton(
        contact, law, trace.held,
        std::vector<ContactState>(law.node_count(), ContactState::stick));
  }
};

/// Of any mesh and any frames, where all nodes stick.
TEST(CoarseStart, keeps_a_uniform_traction) {
  Random random(1);
  SolidProblem problem(moved(brick({9, 7, 1}, {90, 70, 10}), 10, 0.3, random),
                       100);
  problem.move(high_z, [](const Vector3d&) { return Vector3d::Zero(); });
  ContactSurface& surface = problem.surface;
  surface.normal += 0.2 * random_matrix(3, surface.node_count(), random);
  surface.normal.colwise().normalize();
  Relation relation(problem);
  const Vector3d traction(1, -2, 30);
  Matrix3Xd P(3, surface.node_count());
  for (int i = 0; i < surface.node_count(); ++i)
    P.col(i) = surface.frame(i).transpose() * traction * surface.area[i];
  relation.contact.g = -P.reshaped()(relation.contact.primary);
  const std::optional<ContactRows> start = relation.start();
  ASSERT_TRUE(start);
  EXPECT_LT((start->P - P.reshaped()).norm(), 1e-12 * P.norm());
  EXPECT_EQ(start->v.norm(), 0);
}

/// Whose bound is a traction at every node.
TEST(CoarseStart, keeps_a_uniform_bound) {
  Random random(1);
  SolidProblem problem(
      moved(brick({12, 4, 1}, {120, 40, 10}), 10, 0.2, random));
  const int nodes = problem.surface.node_count();
  problem.law.friction.resize(0);
  problem.law.slip_bound = VectorXd::Constant(nodes, 0.5);
  for (const int side : {low_y, high_y}) problem.guide(side, 1);
  problem.guide(high_z, 2);
  problem.guide(low_x, 0);
  problem.load(high_x, {100, 0, 0});
  const Relation relation(problem);
  const std::optional<ContactRows> start = relation.start();
  ASSERT_TRUE(start);
  for (int i = 0; i < nodes; ++i) {
    if (problem.mesh.place(problem.surface.vertex[i]).x() < 60) continue;
    EXPECT_NEAR(start->P[3 * i + 1] / problem.surface.area[i], -0.5, 1e-3);
    EXPECT_GT(start->v[3 * i + 1], 0);
  }
}

/// A start that is near the solution, where many nodes slip: Newton takes two thirds of
/// its steps from sticking nodes.
TEST(CoarseStart, saves_steps) {
  int steps_from_near = 0, steps_from_far = 0;
  for (const int n : {6, 9})
    for (const BlockCase loads : {BlockCase::press, BlockCase::press_x}) {
      const SolidProblem problem =
          block_problem(brick({2 * n, n, n / 2}, {80, 40, 40}), loads, 0.5);
      const Relation relation(problem);
      const std::optional<ContactRows> start = relation.start();
      ASSERT_TRUE(start);
      const ActiveSetResult near = relation.from(*start),
                            far = relation.from_sticking();
      EXPECT_EQ(near.status, ContactStatus::converged);
      EXPECT_EQ(near.state, far.state);
      EXPECT_LT((start->P - far.P).norm(), 0.5 * far.P.norm());
      steps_from_near += near.iterations;
      steps_from_far += far.iterations;
    }
  EXPECT_LT(1.3 * steps_from_near, steps_from_far);
}

/// With planes of symmetry, nodes that are all open, no friction.
RC_GTEST_PROP(CoarseStart, leads_to_the_solution, (Random random)) {
  const double mu = random() % 3 == 0 ? 0 : *real(0, 0.5);
  const SolidProblem problem = random_block(mu, random);
  const Relation relation(problem);
  const std::optional<ContactRows> start = relation.start();
  RC_PRE(start.has_value());
  RC_ASSERT(start->P.allFinite());
  RC_ASSERT(start->v.allFinite());
  const ActiveSetResult near = relation.from(*start),
                        far = relation.from_sticking();
  RC_ASSERT(near.status == ContactStatus::converged);
  RC_ASSERT((near.P - far.P).norm() <= 1e-9 * far.P.norm());
}

}  // namespace
}  // namespace ffcontact
