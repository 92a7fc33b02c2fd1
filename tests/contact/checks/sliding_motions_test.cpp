// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/sliding_motions.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/solve_contact.hpp"
#include "support/pins.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Solved as it is held.
ContactSolution<2> held_solution(Problem problem) {
  add_body_loads(problem.mesh, held(problem), problem.b);
  return solve_contact(problem.mesh, problem.line, problem.law,
                       problem.system());
}

TEST(SlidingMotions, a_pin_without_friction_turns_about_its_axis) {
  for (const double noise : {0.0, 1e-6}) {
    const Problem problem = pin(noise);
    const MatrixXd motions = sliding(problem);
    ASSERT_EQ(motions.cols(), 1);
    // w x r: what it moves at a place r is across r
    for (int v = 0; v < problem.mesh.vertex_count(); ++v) {
      const Vector2d z = motions.col(0).segment<2>(2 * v);
      EXPECT_NEAR(z.dot(problem.mesh.vertices.col(v)), 0,
                  1e-4 * pin_radius * z.norm());
    }
  }
}

TEST(SlidingMotions, friction_springs_and_supports_leave_none) {
  for (const double friction : {0.1, 1e-8}) {
    Problem rough = pin(1e-6);
    set_friction(rough, friction);
    EXPECT_EQ(sliding(rough).cols(), 0);
  }
  Problem on_a_spring = pin(1e-6);
  on_a_spring.A.coeffRef(0, 0) += 1;
  EXPECT_EQ(sliding(on_a_spring).cols(), 0);
  const Problem oval = pin(0, 1, 1.02);
  EXPECT_EQ(sliding(oval).cols(), 0);
}

TEST(SlidingMotions, contact_directions_are_turned_across_them) {
  Problem problem = pin(1e-6);
  const MatrixXd motions = sliding(problem);
  const Matrix2Xd before = problem.line.normal;
  const double turn = turn_across(motions, problem.line);
  EXPECT_GT(turn, 1e-8);
  EXPECT_LT(turn, 1e-5);
  EXPECT_NEAR((problem.line.normal - before).colwise().norm().maxCoeff(), turn,
              1e-15);
  EXPECT_LT(contact_components(problem.line, motions.col(0))
                .row(0)
                .cwiseAbs()
                .maxCoeff(),
            1e-15);
  EXPECT_LT((problem.line.normal.colwise().norm().array() - 1).abs().maxCoeff(),
            1e-15);
}

TEST(SlidingMotions, what_slides_exactly_turns_no_direction) {
  Problem block = body(rectangle(8, 4, 4, 2), material(100, 0.3));
  add_traction(block, top, {0, -1});
  const MatrixXd motions = sliding(block);
  ASSERT_EQ(motions.cols(), 1);
  const Matrix2Xd before = block.line.normal;
  EXPECT_EQ(turn_across(motions, block.line), 0);
  EXPECT_EQ(block.line.normal, before);
  EXPECT_TRUE(holding_loads(block.mesh, motions, block.b).isZero(0));
}

TEST(SlidingMotions, noise_of_loads_is_balanced_and_no_more) {
  Problem block = body(rectangle(8, 4, 4, 2), material(100, 0.3));
  add_traction(block, top, {0, -1});
  add_body_force(block, {1e-6, 0});
  const MatrixXd motions = sliding(block);
  const BodyLoadsOfCells<2> loads = holding_loads(block.mesh, motions, block.b);
  VectorXd held = block.b;
  add_body_loads(block.mesh, loads, held);
  EXPECT_LT((motions.transpose() * held).cwiseAbs().maxCoeff(),
            1e-15 * block.b.lpNorm<1>());
  // here a constant force, that of the loads turned round, to their rounding
  for (int t = 0; t < block.mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vector2d share(-1e-6 * signed_area(block.mesh, t) / 3, 0);
      EXPECT_LT((loads.col(t).segment<2>(2 * k) - share).norm(), 1e-16);
    }
  add_body_force(block, {1e-4, 0});
  EXPECT_EQ(sliding(block).cols(), 0);
}

TEST(SlidingMotions, the_noise_of_coordinates_does_not_turn_a_pin) {
  const ContactSolution<2> exact = held_solution(pin(0));
  ASSERT_EQ(exact.status, ContactStatus::converged);
  for (const double noise : {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4})
    for (const unsigned seed : {1U, 2U, 3U}) {
      const ContactSolution<2> found = held_solution(pin(noise, seed));
      EXPECT_EQ(found.status, ContactStatus::converged) << noise;
      EXPECT_LT((found.force - exact.force).norm(),
                1e-6 * exact.force.norm() + 100 * noise * exact.force.norm())
          << noise;
    }
}

TEST(SlidingMotions, directions_are_turned_in_space_too) {
  Matrix3Xd columns(3, 2);
  columns << 1e-5, 2e-5, 1, 0, 0, 1;
  const VectorXd axis = first_axis_across(columns);
  EXPECT_NEAR(axis.norm(), 1, 1e-15);
  EXPECT_LT((columns.transpose() * axis).norm(), 1e-15);
  EXPECT_GT(axis[0], 0.99);
  EXPECT_EQ(first_axis_across(Matrix3d::Identity()), Vector3d::UnitX());
}

}  // namespace
}  // namespace ffcontact
