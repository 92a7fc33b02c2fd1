// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/straight_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/chains.hpp"
#include "support/pi.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

Matrix2Xd rounded(const Matrix2Xd& points, double unit) {
  return (points / unit).array().round().matrix() * unit;
}

std::vector<int> runs_of(const Matrix2Xd& points) {
  const double size = extent(points);
  return straight_runs(
      points, straight_tolerance(coordinate_precision(points, size), size));
}

TEST(CoordinatePrecision, is_the_last_decimal_of_coordinates_with_few) {
  const Matrix2Xd points = along({0.3, -0.2}, {1 / 3.0, std::sqrt(0.7)}, 7);
  EXPECT_NEAR(coordinate_precision(rounded(points, 1e-6), 1), 1e-6, 1e-12);
  EXPECT_NEAR(coordinate_precision(rounded(points, 1e-8), 1), 1e-8, 1e-14);
  EXPECT_NEAR(coordinate_precision(rounded(points.array() + 1e6, 1e-5), 1),
              1e-5, 1e-11);
}

TEST(CoordinatePrecision,
     is_rounding_where_coordinates_need_all_decimals_or_were_typed) {
  const Matrix2Xd points = along({0.3, -0.2}, {1 / 3.0, std::sqrt(0.7)}, 7);
  EXPECT_LT(coordinate_precision(points, 1), 2e-15);
  EXPECT_LT(coordinate_precision(points.array() + 1e6, 1), 1e-9);
  EXPECT_GT(coordinate_precision(points.array() + 1e6, 1), 1e-10);
  EXPECT_LT(coordinate_precision(along({0, 0}, {80, 40}, 16), 90), 1e-12);
}

TEST(StraightRuns, take_rounded_lines_for_straight_and_keep_shallow_corners) {
  for (const double unit : {1e-12, 1e-8, 1e-6}) {
    const Vector2d corner(std::cos(0.3), std::sin(0.3));
    const Matrix2Xd line = along({0, 0}, corner, 32);
    EXPECT_EQ(runs_of(rounded(line, unit)), (std::vector<int>{0, 32})) << unit;
    const Matrix2Xd bent = one_after_the_other(
        line, along(corner, corner + Vector2d(0.955, 0.297), 8));
    EXPECT_EQ(runs_of(rounded(bent, unit)), (std::vector<int>{0, 32, 40}))
        << unit;
  }
}

RC_GTEST_PROP(StraightRuns, hold_far_from_the_origin, (Random random)) {
  const Uniform angle{0, 2 * pi}, place{-1e6, 1e6};
  const double a = angle(random);
  const Vector2d first(place(random), place(random)),
      corner = first + Vector2d(std::cos(a), std::sin(a));
  const Vector2d last =
      corner + Vector2d(std::cos(a + 0.01), std::sin(a + 0.01));
  RC_ASSERT(runs_of(one_after_the_other(along(first, corner, 20),
                                        along(corner, last, 30))) ==
            (std::vector<int>{0, 20, 50}));
}

TEST(StraightRuns, end_where_the_chain_turns_back) {
  EXPECT_EQ(runs_of(one_after_the_other(along({0, 0}, {1, 0}, 4),
                                        along({1, 0}, {0.5, 0}, 2))),
            (std::vector<int>{0, 4, 6}));
}

}  // namespace
}  // namespace ffcontact
