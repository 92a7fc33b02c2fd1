// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/displacement/following_faces.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/bonded_solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The sides of bodies whose faces follow.
std::set<int> following_sides(const SolidStack& stack) {
  const SolidProblem& problem = stack.problem;
  std::set<int> sides;
  for (const FollowingPart& part :
       following_parts(problem.faces, problem.surface))
    sides.insert(
        problem.mesh.boundary_label[problem.faces.boundary_index[part.face]]);
  return sides;
}

TEST(FollowingFaces, are_those_of_the_finer_surface) {
  const SolidStack upper = bonded_bricks({5, 4, 1}, {3, 2, 1}),
                   lower = bonded_bricks({3, 2, 1}, {5, 4, 1});
  EXPECT_EQ(following_sides(upper), std::set<int>{upper.label(0, low_z)});
  EXPECT_EQ(following_sides(lower), std::set<int>{lower.label(1, high_z)});
}

TEST(FollowingFaces, are_covered) {
  const SolidStack below =
      bonded_stack({brick_at({5, 5, 1}, {3, 3, 1}, {-1, -1, 0}),
                    brick_at({2, 1, 1}, {1, 1, 1}, {0.1, 0.2, -1})});
  EXPECT_EQ(following_sides(below), std::set<int>{below.label(1, high_z)});
  const SolidStack above =
      bonded_stack({brick_at({2, 1, 1}, {1, 1, 1}, {0.1, 0.2, 0}),
                    brick_at({5, 5, 1}, {3, 3, 1}, {-1, -1, -1})});
  EXPECT_EQ(following_sides(above), std::set<int>{above.label(0, low_z)});
}

/// A linear displacement of all has no jump, one of the other body has its own.
TEST(FollowingFaces, jump_by_what_the_other_body_does) {
  const SolidStack two = bonded_bricks({5, 4, 1}, {3, 2, 1});
  const SolidMesh& mesh = two.problem.mesh;
  const VectorXd all = nodal_values(mesh, linear_solid_field);
  VectorXd lower = all;
  lower.head(3 * two.joined.first_vertex[1]).setZero();
  for (const FollowingPart& part :
       following_parts(two.problem.faces, two.problem.surface)) {
    EXPECT_TRUE(part.is_covered);
    EXPECT_LT(part.jumps(two.problem.faces, all).norm(), 1e-15);
    const Matrix3d jumps = part.jumps(two.problem.faces, lower);
    for (int k = 0; k < 3; ++k)
      EXPECT_LT((jumps.col(k) - linear_solid_field(mesh.vertices.col(
                                    two.problem.faces.vertices(k, part.face))))
                    .norm(),
                1e-15);
  }
}

}  // namespace
}  // namespace ffcontact
