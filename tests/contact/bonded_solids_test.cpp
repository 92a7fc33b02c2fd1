// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/bonded_solids.hpp"

#include <gtest/gtest.h>

#include "ffcontact/linear/norms.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Linear displacements pass through surfaces that do not match, in one step.
RC_GTEST_PROP(BondedSolids, linear_displacements_pass, (Random random)) {
  SolidStack two = random_bonded_bricks(random);
  prescribe_uniform_stress(two);
  const ContactSolution<3> solution = two.problem.solve();
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(solution.iterations == 1);
  RC_ASSERT(relative_difference(
                solution.displacement,
                nodal_values(two.problem.mesh, linear_solid_field)) < 1e-11);
}

TEST(BondedSolids, meshes_that_match_are_one_mesh) {
  SolidStack two = bonded_bricks({3, 2, 2}, {3, 2, 2});
  pull(two);
  SolidProblem held(brick_at({3, 2, 4}, {3, 2, 2}, {0, 0, -1}));
  bond(held);
  held.load(high_z, {3, 1, 7});
  const ContactSolution<3> whole = held.solve(), parts = two.problem.solve();
  ASSERT_TRUE(whole.accepted({}));
  ASSERT_TRUE(parts.accepted({}));
  EXPECT_EQ(parts.state, all_stick(two.problem.surface.node_count()));
  for (int v = 0; v < two.problem.mesh.vertex_count(); ++v) {
    Index same;
    (held.mesh.vertices.colwise() - two.problem.mesh.vertices.col(v))
        .colwise()
        .norm()
        .minCoeff(&same);
    EXPECT_LT((whole.displacement.segment<3>(3 * same) -
               parts.displacement.segment<3>(3 * v))
                  .norm(),
              1e-11 * max_norm(whole.displacement));
  }
}

TEST(BondedSolids, carry_tension_and_shear_by_all_solvers) {
  SolidStack two = bonded_bricks({3, 2, 2}, {4, 3, 2});
  pull(two);
  const ContactSolution<3> direct = two.problem.solve();
  ASSERT_TRUE(direct.accepted({}));
  EXPECT_NEAR(direct.force.row(0).sum(), 7 * 6, 1e-9);
  ContactSettings fixed_point, multigrid;
  fixed_point.solver = ContactSolver::fixed_point;
  multigrid.linear = LinearSolver::multigrid;
  EXPECT_EQ(two.problem.solve(fixed_point).iterations, 1);
  for (const ContactSettings& settings : {fixed_point, multigrid}) {
    const ContactSolution<3> other = two.problem.solve(settings);
    ASSERT_TRUE(other.accepted(settings));
    EXPECT_LT(relative_difference(other.displacement, direct.displacement),
              1e-8);
    EXPECT_LT(relative_difference(other.force, direct.force), 1e-7);
  }
}

TEST(BondedSolids, without_supports_are_held_by_what_they_are_bonded_to) {
  SolidStack three = bonded_stack({brick_at({2, 2, 1}, {3, 2, 1}, {0, 0, 1}),
                                   brick({3, 2, 1}, {3, 2, 1}),
                                   brick_at({2, 3, 1}, {3, 2, 1}, {0, 0, -1})});
  three.problem.move(three.label(2, low_z), linear_solid_field);
  three.problem.load(three.label(0, high_x), {0, 5, 0});
  EXPECT_TRUE(three.problem.solve().accepted({}));
}

}  // namespace
}  // namespace ffcontact
