// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "ffcontact/bounds/quantity_bounds.hpp"
#include "support/bounded_solids.hpp"
#include "support/refusals.hpp"
#include "support/solid_bodies.hpp"

namespace ffcontact {
namespace {

using namespace test;

const Vector3d block_size(80, 40, 40);

SolidProblem tresca_block(int cells, double slip_bound) {
  SolidProblem problem = block_problem(
      brick({2 * cells, cells, cells}, block_size), BlockCase::press, 0);
  if (slip_bound > 0)
    problem.law.slip_bound = on_all_nodes(problem, slip_bound);
  return problem;
}

/// The solution is linear, and so is the response to the quantity.
TEST(BoundsOfSolids, have_what_the_mesh_knows_exactly_between_them) {
  SolidProblem problem(brick({3, 2, 2}, {3, 2, 2}));
  problem.guide(low_x, 0);
  problem.guide(low_y, 1);
  problem.load(high_z, {0, 0, -5});
  const QuantityBounds found = SolidWithAnswer(problem).bounds(
      on_label<3>(problem.mesh, high_z, {0, 0, 1}));
  const double exact = -5 * 2.0 / 13e3 * 6;
  EXPECT_LE(found.lower, exact);
  EXPECT_GE(found.upper, exact);
  EXPECT_LT(found.width(), 1e-10 * std::abs(exact));
}

/// Widths in % of the midpoint, each with the interval of the finer mesh inside but for
/// the steps that are searched.
TEST(BoundsOfSolids, get_narrower_with_the_mesh) {
  for (const double slip_bound : {0.0, 2.0}) {
    const auto found = [&](int cells) {
      const SolidWithAnswer solved(tresca_block(cells, slip_bound));
      return solved.bounds(
          on_label<3>(solved.problem.mesh, high_x, {1.0 / 1600, 0, 0}));
    };
    const QuantityBounds coarse = found(2), fine = found(4);
    EXPECT_GT(fine.upper, coarse.lower);
    EXPECT_LT(fine.lower, coarse.upper);
    EXPECT_LT(fine.width(), 0.6 * coarse.width());
  }
}

TEST(BoundsOfSolids, are_apart_by_what_the_cells_contribute) {
  const SolidWithAnswer solved(tresca_block(2, 2));
  const QuantityBounds found = solved.bounds(
      in_cells(solved.problem.mesh, solved.body.hooke, {1, -2, 0.5},
               (VectorOf<6>() << 0, 0, 1, 0, 0.3, 0).finished(),
               [](const Vector3d& x) { return x.x() < 40; }));
  ASSERT_TRUE(found.found());
  EXPECT_NEAR(found.local.sum(), found.width(), 1e-10 * found.width());
  EXPECT_GE(found.local.minCoeff(), -1e-12 * found.width());
}

/// The lower side of one of two bricks faces the upper side of the other.
SolidStack two_bricks(const Vector3i& above, const Vector3i& below,
                      double slip_bound) {
  SolidMesh upper = brick(above, {2, 1, 1});
  upper.vertices.row(2).array() += 1;
  SolidStack stack({upper, brick(below, {2, 1, 1})}, 0);
  SolidProblem& problem = stack.problem;
  if (slip_bound > 0)
    problem.law.slip_bound = on_all_nodes(problem, slip_bound);
  problem.move(stack.label(1, low_z),
               [](const Vector3d&) { return Vector3d::Zero(); });
  problem.move(stack.label(0, high_z), [](const Vector3d& x) {
    return Vector3d(2e-3, 0, -1e-3 - 2e-4 * x.x());
  });
  problem.load(stack.label(1, high_x), {3, 0, 0});
  return stack;
}

/// Of a mean on a side of the upper one, on meshes that are nested.
void expect_narrower(const SolidStack& coarse, const SolidStack& fine,
                     double times, int side = high_x,
                     const Vector3d& w = {1, 0, 0.5}) {
  const auto found = [&](const SolidStack& stack) {
    return SolidWithAnswer(stack.problem)
        .bounds(on_label<3>(stack.problem.mesh, stack.label(0, side), w));
  };
  const QuantityBounds wide = found(coarse), narrow = found(fine);
  EXPECT_EQ(wide.reason, "");
  EXPECT_EQ(narrow.reason, "");
  EXPECT_NEAR(narrow.local.sum(), narrow.width(), 1e-10 * narrow.width());
  EXPECT_GT(narrow.upper, wide.lower);
  EXPECT_LT(narrow.lower, wide.upper);
  EXPECT_LT(narrow.width(), times * wide.width());
}

TEST(BoundsOfSolids, are_of_bodies_that_face_each_other) {
  const Vector3i cells(4, 2, 2);
  for (const double bound : {0.0, 2.0})
    expect_narrower(two_bricks(cells, cells, bound),
                    two_bricks(2 * cells, 2 * cells, bound), 0.6);
}

TEST(BoundsOfSolids, are_of_bodies_whose_meshes_do_not_match) {
  const Vector3i above(4, 2, 2), below(5, 3, 2);
  for (const double bound : {0.0, 2.0})
    expect_narrower(two_bricks(above, below, bound),
                    two_bricks(2 * above, 2 * below, bound), 0.7);
}

/// Their tractions oscillate: over steps the width has several minima.
TEST(BoundsOfSolids, are_of_the_contact_of_meshes_that_do_not_match) {
  const Vector3i above(2, 2, 1), below(1, 1, 1);
  expect_narrower(two_bricks(above, below, 0),
                  two_bricks(2 * above, 2 * below, 0), 0.7, low_z,
                  {-0.6, 0.5, 0.15});
}

std::string refused(const SolidProblem& problem) {
  const SolidWithAnswer solved(problem);
  return refusal([&] {
    solved.bounds(on_label<3>(problem.mesh, high_x, {1, 0, 0}));
  });
}

TEST(BoundsOfSolids, are_refused_with_coulombs_law) {
  EXPECT_NE(refused(block_problem(brick({4, 2, 2}, block_size),
                                  BlockCase::press, 0.5))
                .find("Tresca's law alone"),
            std::string::npos);
}

}  // namespace
}  // namespace ffcontact
