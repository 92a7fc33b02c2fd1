// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/smooth_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(CubicTriangle, is_a_sphere_to_fourth_order, (Random random)) {
  const double h = *real(0.05, 0.5);
  Matrix3d corners;
  for (int i = 0; i < 3; ++i)
    corners.col(i) =
        (Vector3d::Ones() + h * 0.5 * random_vector(3, random)).normalized();
  Vector3d place = random_vector(3, random).cwiseAbs();
  place /= place.sum();
  const Vector3d x = point_on_cubic_triangle(corners, corners, place);
  const double longest = std::max({(corners.col(0) - corners.col(1)).norm(),
                                   (corners.col(1) - corners.col(2)).norm(),
                                   (corners.col(2) - corners.col(0)).norm()});
  RC_ASSERT(std::abs(x.norm() - 1) < 0.02 * std::pow(longest, 4) + 1e-14);
}

RC_GTEST_PROP(NearestPlace, is_nearer_than_any_other, (Random random)) {
  Matrix3d corners;
  for (int i = 0; i < 3; ++i) corners.col(i) = random_vector(3, random);
  const Vector3d x = 2 * random_vector(3, random);
  const Vector3d place = nearest_place(corners, x);
  RC_ASSERT(place.minCoeff() >= 0);
  RC_ASSERT(std::abs(place.sum() - 1) < 1e-14);
  const double distance = (corners * place - x).norm();
  for (int k = 0; k < 50; ++k) {
    Vector3d other = random_vector(3, random).cwiseAbs();
    other /= other.sum();
    RC_ASSERT((corners * other - x).norm() >= distance * (1 - 1e-12));
  }
}

Vector3d random_place(Random& random) {
  const Vector3d place = random_vector(3, random).cwiseAbs();
  return place / place.sum();
}

RC_GTEST_PROP(CubicTriangle, of_a_plane_is_the_triangle, (Random random)) {
  const Matrix3d corners = random_matrix(3, 3, random);
  const Vector3d normal =
      (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
  RC_PRE(normal.norm() > 1e-2);
  const Matrix3d normals = normal.normalized().replicate<1, 3>();
  const Vector3d place = random_place(random);
  RC_ASSERT((point_on_cubic_triangle(corners, normals, place) - corners * place)
                .norm() < 1e-12);
}

/// Neighbours meet without a gap.
RC_GTEST_PROP(CubicTriangle, has_sides_of_their_ends_alone, (Random random)) {
  Matrix3d corners = random_matrix(3, 3, random), normals = corners;
  for (int i = 0; i < 3; ++i)
    normals.col(i) = (Vector3d::Unit(2) + 0.2 * normals.col(i)).normalized();
  const double part = *real(0, 1);
  const Vector3d place(part, 1 - part, 0);
  const Vector3d x = point_on_cubic_triangle(corners, normals, place);
  corners.col(2) += random_vector(3, random);
  normals.col(2) = normals.col(0);
  RC_ASSERT((point_on_cubic_triangle(corners, normals, place) - x).norm() <
            1e-15);
}

/// Bezier's cubic of a circle's ends and of this length of its tangents has the middle of
/// the arc, however long that is.
TEST(CubicTriangle, has_the_middle_of_an_arc) {
  for (const double half : {0.1, 0.5, 1.2}) {
    Matrix3d corners;
    corners << std::sin(half), -std::sin(half), 0, 0, 0, 1, std::cos(half),
        std::cos(half), 0;
    const Vector3d middle =
        point_on_cubic_triangle(corners, corners, {0.5, 0.5, 0});
    EXPECT_LT((middle - Vector3d::Unit(2)).norm(), 1e-14) << half;
  }
}

/// Beyond a side, beyond a corner and above the inside.
TEST(NearestPlace, is_on_sides_at_corners_and_inside) {
  Matrix3d corners;
  corners << 0, 2, 0, 0, 0, 2, 0, 0, 0;
  const auto is = [&](const Vector3d& x, const Vector3d& place) {
    return (nearest_place(corners, x) - place).norm() < 1e-15;
  };
  EXPECT_TRUE(is({0.5, 1, 7}, {0.25, 0.25, 0.5}));
  EXPECT_TRUE(is({0.5, -3, 1}, {0.75, 0.25, 0}));
  EXPECT_TRUE(is({2, 2, -1}, {0, 0.5, 0.5}));
  EXPECT_TRUE(is({-1, 0.5, 0}, {0.75, 0, 0.25}));
  EXPECT_TRUE(is({-1, -2, 0}, {1, 0, 0}));
  EXPECT_TRUE(is({5, -1, 0}, {0, 1, 0}));
  EXPECT_TRUE(is({-1, 9, 0}, {0, 0, 1}));
}

}  // namespace
}  // namespace ffcontact
