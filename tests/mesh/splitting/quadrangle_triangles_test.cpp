// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/splitting/quadrangle_triangles.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

using Quadrangle = Matrix<double, 3, 4>;

Quadrangle plane_quadrangle(const Matrix<double, 2, 4>& corners) {
  Quadrangle result = Quadrangle::Zero();
  result.topRows<2>() = corners;
  return result;
}

Quadrangle corners_at(std::initializer_list<Vector2d> places) {
  Matrix<double, 2, 4> corners;
  int k = 0;
  for (const Vector2d& place : places) corners.col(k++) = place;
  return plane_quadrangle(corners);
}

using Ends = std::set<int>;

/// The numbers of the vertices in both triangles.
Ends cut_between(const Quadrangle& corners, const Vector4i& numbers) {
  const auto triangles = quadrangle_triangles(corners, numbers);
  if (!triangles) return {};
  const auto numbers_of = [&](const Vector3i& t) {
    return std::set<int>{numbers[t[0]], numbers[t[1]], numbers[t[2]]};
  };
  const std::set<int> one = numbers_of((*triangles)[0]),
                      other = numbers_of((*triangles)[1]);
  Ends both;
  std::set_intersection(one.begin(), one.end(), other.begin(), other.end(),
                        std::inserter(both, both.end()));
  return both;
}

const Vector4i in_order(0, 1, 2, 3);

TEST(QuadrangleTriangles, are_on_both_sides_of_the_shorter_diagonal) {
  const auto skewed = [](double shift) {
    return corners_at({{0, 0}, {2, 0}, {2 + shift, 1}, {shift, 1}});
  };
  EXPECT_EQ(cut_between(skewed(0.1), in_order), (Ends{1, 3}));
  EXPECT_EQ(cut_between(skewed(-0.1), in_order), (Ends{0, 2}));
  EXPECT_EQ(cut_between(skewed(1e-8), in_order), (Ends{1, 3}));
}

TEST(QuadrangleTriangles,
     begin_at_the_lowest_number_where_diagonals_are_equal) {
  for (const double shift : {0.0, 1e-15, -1e-15, 1e-11, -1e-11}) {
    const Quadrangle brick =
        corners_at({{0, 0}, {2, 0}, {2 + shift, 1}, {shift, 1}});
    EXPECT_EQ(cut_between(brick, {4, 5, 6, 7}), (Ends{4, 6})) << shift;
    EXPECT_EQ(cut_between(brick, {5, 4, 7, 6}), (Ends{4, 6})) << shift;
    EXPECT_EQ(cut_between(brick, {9, 8, 3, 7}), (Ends{9, 3})) << shift;
    EXPECT_EQ(cut_between(brick, {9, 8, 7, 3}), (Ends{8, 3})) << shift;
  }
}

/// An arrow head is cut from its notch, though that diagonal is the longer one.
TEST(QuadrangleTriangles, are_inside_where_a_corner_points_inward) {
  const Quadrangle arrow = corners_at({{0, 0}, {10, -0.1}, {9, 0}, {10, 0.1}});
  EXPECT_EQ(cut_between(arrow, in_order), (Ends{0, 2}));
  EXPECT_EQ(cut_between(arrow, {3, 2, 1, 0}), (Ends{1, 3}));
  EXPECT_EQ(cut_between(arrow, {1, 0, 3, 2}), (Ends{1, 3}));
}

TEST(QuadrangleTriangles, are_not_flat_where_three_corners_are_on_a_line) {
  EXPECT_EQ(cut_between(corners_at({{0, 0}, {1, 0}, {2, 0}, {1, 9}}), in_order),
            (Ends{1, 3}));
  EXPECT_EQ(
      cut_between(corners_at({{0, 0}, {1, 1e-12}, {2, 0}, {1, 9}}), in_order),
      (Ends{1, 3}));
}

TEST(QuadrangleTriangles, are_none_where_no_diagonal_is_inside) {
  const auto is_refused = [](const Quadrangle& corners, const Vector4i& n) {
    return !quadrangle_triangles(corners, n);
  };
  EXPECT_TRUE(
      is_refused(corners_at({{0, 0}, {1, 0}, {2, 0}, {3, 0}}), in_order));
  EXPECT_TRUE(
      is_refused(corners_at({{0, 0}, {0, 0}, {0, 0}, {0, 0}}), in_order));
  EXPECT_TRUE(
      is_refused(corners_at({{0, 0}, {1, 0}, {0, 1}, {1, 1}}), in_order));
  EXPECT_TRUE(
      is_refused(corners_at({{0, 0}, {3, 0}, {0, 1}, {1, 1}}), in_order));
  EXPECT_TRUE(
      is_refused(corners_at({{0, 0}, {1, 0}, {1, 1}, {1, 1}}), {0, 1, 2, 2}));
  EXPECT_TRUE(is_refused(
      corners_at({{0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}, {0.6, 0.6}}), in_order));
}

Vector3d vector_area(const Quadrangle& corners, const Vector3i& triangle) {
  const Vector3d a = corners.col(triangle[1]) - corners.col(triangle[0]);
  return a.cross(corners.col(triangle[2]) - corners.col(triangle[0])) / 2;
}

/// Square, brick, skewed or warped, anywhere in space.
Quadrangle random_quadrangle(Random& random) {
  Quadrangle corners = corners_at({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const double scale[] = {0, 0.1, 0.5, 1};
  corners += scale[random() % 4] * random_matrix(3, 4, random);
  const Matrix3d any = random_matrix(3, 3, random);
  return (any * corners).colwise() + Vector3d(random_vector(3, random));
}

/// Where the diagonal ends, if it does so in any order of the corners.
std::optional<Ends> same_in_any_order(const Quadrangle& corners,
                                      const Vector4i& numbers) {
  const Ends ends = cut_between(corners, numbers);
  for (const int step : {1, 3})
    for (int first = 0; first < 4; ++first) {
      Vector4i order;
      for (int k = 0; k < 4; ++k) order[k] = (first + step * k) % 4;
      if (cut_between(corners(Eigen::all, order), numbers(order)) != ends)
        return std::nullopt;
    }
  return ends;
}

Vector4i random_numbers(Random& random) {
  Vector4i numbers(3, 9, 1, 40);
  std::shuffle(numbers.begin(), numbers.end(), random);
  return numbers;
}

RC_GTEST_PROP(QuadrangleTriangles, do_not_depend_on_the_order_of_corners,
              (Random random)) {
  const Quadrangle corners = random_quadrangle(random);
  RC_ASSERT(same_in_any_order(corners, random_numbers(random)).has_value());
}

/// An arrow head whose notch becomes a corner that points outward as it moves by a last
/// digit.
RC_GTEST_PROP(QuadrangleTriangles, do_not_depend_on_the_order_to_the_last_digit,
              (Random random)) {
  for (int turns = 0; turns < 30; ++turns) {
    const Vector4i numbers = random_numbers(random);
    const Eigen::Quaterniond turn(Vector4d(random_vector(4, random)));
    const Matrix3d any = turn.normalized().toRotationMatrix();
    const auto with_notch = [&](double at) -> Quadrangle {
      return any * corners_at({{0, 0}, {4, -1}, {at, 0.01}, {4, 1.3}});
    };
    const Ends from_notch = cut_between(with_notch(3), numbers);
    double notch = 3, none = 6;
    for (int step = 0; step < 60; ++step) {
      const double middle = (notch + none) / 2;
      const bool is_notch =
          cut_between(with_notch(middle), numbers) == from_notch;
      (is_notch ? notch : none) = middle;
    }
    RC_ASSERT(std::abs(notch - 4) < 0.1);
    for (int digits = -4; digits <= 4; ++digits)
      RC_ASSERT(same_in_any_order(with_notch(notch + digits * 0x1p-50), numbers)
                    .has_value());
  }
}

RC_GTEST_PROP(QuadrangleTriangles, are_none_of_corners_on_a_line,
              (Random random)) {
  const Vector3d start = random_vector(3, random),
                 along = random_vector(3, random);
  const Vector4d at = random_vector(4, random);
  const Quadrangle corners = (along * at.transpose()).colwise() + start;
  RC_ASSERT(!quadrangle_triangles(corners, in_order));
}

RC_GTEST_PROP(QuadrangleTriangles, run_around_as_the_quadrangle_does,
              (Random random)) {
  const Quadrangle corners = random_quadrangle(random);
  const auto triangles = quadrangle_triangles(corners, in_order);
  if (!triangles) return;
  const Vector3d diagonal = corners.col(2) - corners.col(0);
  const Vector3d whole = diagonal.cross(corners.col(3) - corners.col(1)) / 2;
  const Vector3d one = vector_area(corners, (*triangles)[0]),
                 other = vector_area(corners, (*triangles)[1]);
  RC_ASSERT((one + other - whole).norm() < 1e-13);
  RC_ASSERT(one.dot(whole) > 0);
  RC_ASSERT(other.dot(whole) > 0);
}

}  // namespace
}  // namespace ffcontact
