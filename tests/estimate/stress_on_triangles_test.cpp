// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/stress_on_triangles.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/bodies.hpp"
#include "support/estimates.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// No cut divides a side by 2 : 3, which would put corners' points onto borders of
/// subtriangles.
Bodies blocks(const Vector2d& corner) {
  Bodies two = bodies({shifted(rectangle(3, 2, 6, 3), corner + Vector2d(0, 4)),
                       shifted(rectangle(7, 2, 6, 4), corner)},
                      {material(70e3, 0.3), material(100e3, 0.2)},
                      {{0, bottom, 1, top}});
  add_traction(two.problem, two.label(0, top), {1, -10});
  clamp(two.problem, two.label(1, bottom));
  set_friction(two.problem, 0.4);
  return two;
}

bool contains(const Matrix<double, 2, 3>& corners, const Vector2d& x) {
  const auto twice_area = [](const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  for (int k = 0; k < 3; ++k)
    if (twice_area(corners.col((k + 1) % 3) - corners.col(k),
                   x - corners.col(k)) < 0)
      return false;
  return true;
}

Matrix<double, 2, 3> subtriangle(const CellCorners<2>& corners, int k) {
  Matrix<double, 2, 3> sub;
  sub << corners.col((k + 1) % 3), corners.col((k + 2) % 3),
      corners.rowwise().mean();
  return sub;
}

/// A number for every subtriangle of the refinement comes back where a point of the cut
/// triangle lies in it.
void expect_numbers_of_places(const Vector2d& corner) {
  const Bodies two = blocks(corner);
  const Mesh& mesh = two.problem.mesh;
  Estimate<2> estimate = estimated(two.problem, solved(two.problem), sweeps(0));
  ASSERT_TRUE(estimate.refinement.has_value());
  const CommonRefinement& refinement = *estimate.refinement;
  for (int t = 0; t < refinement.mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k)
      estimate.stress[t].middleCols<3>(3 * k).setConstant(3 * t + k);
  const std::vector<SubcellStress<2>> stress =
      stress_on_triangles(mesh, estimate);
  ASSERT_EQ(static_cast<int>(stress.size()), mesh.cell_count());
  std::set<double> seen;
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Matrix<double, 2, 3> sub = subtriangle(corners_of(mesh, t), k);
      for (int c = 0; c < 3; ++c) {
        const Vector2d x =
            sub.col(c) + 1e-6 * (sub.rowwise().mean() - sub.col(c));
        const double number = stress[t](0, 3 * k + c);
        const int cut = static_cast<int>(std::lround(number)) / 3,
                  part = static_cast<int>(std::lround(number)) % 3;
        EXPECT_NEAR(number, std::lround(number), 1e-9);
        EXPECT_EQ(refinement.parent[cut], t);
        EXPECT_TRUE(
            contains(subtriangle(corners_of(refinement.mesh, cut), part), x));
        seen.insert(std::lround(number));
      }
    }
  EXPECT_GT(static_cast<int>(seen.size()), 3 * mesh.cell_count());
}

TEST(StressOnTriangles, is_that_of_the_subtriangle_around_the_point) {
  expect_numbers_of_places({0, 0});
}

TEST(StressOnTriangles, is_that_of_the_place_far_from_the_origin) {
  expect_numbers_of_places({1e5, -1e5});
}

}  // namespace
}  // namespace ffcontact
