// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/surface_supports.hpp"

#include <gtest/gtest.h>

#include "support/bonded_solids.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Supports that carry both bodies along hold no vertex inside the other body, though free
/// vertices are beside those of them that it faces.
TEST(SurfaceSupports, may_carry_bodies_along) {
  SolidStack two(
      {brick({3, 4, 1}, {3, 2, 1}), brick_at({4, 3, 1}, {3, 2, 1}, {0, 0, -1})},
      0.3);
  const auto carry = [](const Vector3d&) { return Vector3d(0, 0.01, -0.02); };
  for (const int body : {0, 1}) two.problem.move(two.label(body, low_x), carry);
  two.problem.load(two.label(0, high_z), {0, 0, -1});
  EXPECT_EQ(refusal([&] { two.problem.solve(); }), "accepted");
}

/// Into the other body, whose vertices beside the held ones are free.
TEST(SurfaceSupports, are_refused_that_hold_bodies_in_each_other) {
  SolidStack two(
      {brick({4, 3, 1}, {3, 2, 1}), brick_at({3, 4, 1}, {3, 2, 1}, {0, 0, -1})},
      0.3);
  for (const int body : {0, 1})
    two.problem.move(two.label(body, low_x), [&](const Vector3d&) {
      return Vector3d(0, 0, body == 0 ? -0.02 : -0.01);
    });
  EXPECT_TRUE(says(refusal([&] { two.problem.solve(); }),
                   "no admissible displacement: prescribed displacements hold "
                   "vertex"));
}

TEST(SurfaceSupports, may_move_what_free_vertices_are_bonded_to) {
  SolidStack two = bonded_bricks({3, 4, 1}, {4, 3, 1});
  two.problem.move(two.label(0, low_x),
                   [](const Vector3d&) { return Vector3d(0, 0.01, 0); });
  two.problem.move(two.label(1, low_z),
                   [](const Vector3d&) { return Vector3d::Zero(); });
  EXPECT_TRUE(two.problem.solve().accepted({}));
}

TEST(SurfaceSupports, are_refused_that_hold_bonded_bodies_apart) {
  SolidProblem problem(brick({2, 2, 1}, {1, 1, 1}));
  bond(problem);
  problem.move(low_x, [](const Vector3d&) { return Vector3d(0, 1e-3, 0); });
  EXPECT_TRUE(
      says(refusal([&] { problem.solve(); }),
           "prescribed displacements hold what is bonded 0.001 apart at"));
}

}  // namespace
}  // namespace ffcontact
