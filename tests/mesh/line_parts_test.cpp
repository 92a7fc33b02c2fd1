// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/line_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/mesh/turns.hpp"
#include "support/chains.hpp"
#include "support/pi.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr double corner = 30.5 * pi / 180;

std::vector<LinePart> parts_of(const Matrix2Xd& points) {
  return line_parts(points, 1e-9, corner);
}

/// Edges that curves have.
int edges_of_curves(const std::vector<LinePart>& parts) {
  int count = 0;
  for (const LinePart& part : parts)
    if (!part.straight) count += part.edges();
  return count;
}

/// Where a loop starts, and its parts from there.
std::vector<LinePart> parts_of_loop(const Matrix2Xd& loop,
                                    int* start = nullptr) {
  const int first = loop_start(loop, 1e-9, corner);
  if (start) *start = first;
  const Index n = loop.cols() - 1;
  Matrix2Xd turned(2, n + 1);
  for (Index k = 0; k <= n; ++k) turned.col(k) = loop.col((k + first) % n);
  return parts_of(turned);
}

Matrix2Xd circle(int edges) { return arc(5, 0, 2 * pi, edges); }

/// Two straight sides of `sides` edges and two half circles of `halves`, counter-clockwise;
/// starting in the middle of a half circle.
Matrix2Xd slot(int sides, int halves) {
  Matrix2Xd right = arc(5, 0, pi, halves);
  right.row(0).array() += 10;
  Matrix2Xd left = arc(5, pi, 2 * pi, halves);
  left.row(0).array() -= 10;
  const Matrix2Xd loop = one_after_the_other(
      one_after_the_other(right, along(right.col(halves), left.col(0), sides)),
      one_after_the_other(left, along(left.col(halves), right.col(0), sides)));
  const Index n = loop.cols() - 1, from = halves / 2;
  Matrix2Xd turned(2, n + 1);
  for (Index k = 0; k <= n; ++k) turned.col(k) = loop.col((k + from) % n);
  turned.col(n) = turned.col(0);
  return turned;
}

TEST(LineParts, of_an_arc_between_straight_lines_are_three) {
  const Matrix2Xd curve = arc(5, 0, 0.6, 12);
  const Vector2d end = curve.col(12), leaving(std::cos(0.6), std::sin(0.6));
  const Matrix2Xd chain =
      one_after_the_other(one_after_the_other(along({-4, 0}, {0, 0}, 5), curve),
                          along(end, end + 3 * leaving, 4));
  const std::vector<LinePart> parts = parts_of(chain);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_TRUE(parts[0].straight && !parts[1].straight && parts[2].straight);
  EXPECT_EQ(parts[1].first, 5);
  EXPECT_EQ(parts[1].last, 17);
}

TEST(LineParts, of_a_curve_with_a_corner_are_two) {
  const Matrix2Xd first = arc(5, 0, 0.5, 10);
  Matrix2Xd second = arc(5, 0.7, 1.2, 10);
  second.colwise() += first.col(10) - second.col(0).eval();
  const std::vector<LinePart> parts =
      parts_of(one_after_the_other(first, second));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].last, 10);
}

TEST(LineParts, of_a_polygon_are_its_sides) {
  EXPECT_EQ(parts_of(arc(5, 0, 2.4, 4)).size(), 4u)
      << "34 degrees at each vertex";
  EXPECT_EQ(parts_of(arc(5, 0, 2.4, 8)).size(), 1u)
      << "17 degrees at each vertex";
  EXPECT_EQ(parts_of(arc(5, 0, 0.2, 2)).size(), 2u) << "two edges are no curve";
  const Matrix2Xd corners = arc(5, 0, 0.6, 4);
  Matrix2Xd sides = corners.leftCols(1);
  for (int k = 0; k < 4; ++k)
    sides = one_after_the_other(sides,
                                along(corners.col(k), corners.col(k + 1), 3));
  EXPECT_EQ(parts_of(sides).size(), 4u) << "sides of three edges";
}

TEST(LineParts, of_twelve_edges_of_a_circle_are_one_curve_and_of_eleven_none) {
  Matrix2Xd twelve = circle(12);
  twelve.col(12) = twelve.col(0);
  EXPECT_EQ(edges_of_curves(parts_of_loop(twelve)), 12);
  Matrix2Xd eleven = circle(11);
  eleven.col(11) = eleven.col(0);
  EXPECT_EQ(edges_of_curves(parts_of_loop(eleven)), 0);
}

TEST(LineParts, of_a_slot_are_two_half_circles_wherever_its_loop_begins) {
  for (const int sides : {1, 2, 5})
    for (const int halves : {6, 7, 20}) {
      const std::vector<LinePart> parts = parts_of_loop(slot(sides, halves));
      ASSERT_EQ(parts.size(), 4) << sides << " " << halves;
      EXPECT_EQ(edges_of_curves(parts), 2 * halves);
      for (const LinePart& part : parts)
        EXPECT_TRUE(part.straight ||
                    (part.goes_on_before && part.goes_on_after));
    }
}

TEST(LineParts, of_a_fillet_of_three_edges_go_on_along_sides_of_one_edge) {
  const Matrix2Xd fillet = arc(1, 0, pi / 2, 3);
  const Matrix2Xd chain = one_after_the_other(
      one_after_the_other(along({-8, 0}, {0, 0}, 1), fillet),
      along({1, 1}, {1, 9}, 1));
  const std::vector<LinePart> parts = parts_of(chain);
  ASSERT_EQ(parts.size(), 3);
  EXPECT_FALSE(parts[1].straight);
  EXPECT_TRUE(parts[1].goes_on_before && parts[1].goes_on_after);
  const SmoothCurve<2> curve = curve_of(chain, parts, 1);
  for (int k = 0; k <= 3; ++k)
    EXPECT_LT((curve.tangents.col(k) -
               Vector2d(std::cos(pi / 6 * k), std::sin(pi / 6 * k)))
                  .norm(),
              1e-14)
        << k;
}

TEST(LineParts, that_meet_a_side_at_a_corner_do_not_go_on_along_it) {
  // the side turns by 12 degrees where a tangential one turns by 3
  const double half = 3 * pi / 180, off = 9 * pi / 180;
  const Matrix2Xd chain = one_after_the_other(
      along({-4 * std::cos(off), 4 * std::sin(off)}, {0, 0}, 4),
      arc(5, 0, 20 * half, 10));
  const std::vector<LinePart> parts = parts_of(chain);
  ASSERT_EQ(parts.size(), 2);
  EXPECT_FALSE(parts[1].goes_on_before);
}

TEST(LineParts, that_bend_the_other_way_on_are_one_curve) {
  Matrix2Xd wave(2, 21);  // the sine's inflections are at points 5, 10, 15
  for (int k = 0; k <= 20; ++k)
    wave.col(k) << 0.2 * k, 0.2 * std::sin(pi * 0.2 * k);
  const std::vector<LinePart> parts = parts_of(wave);
  EXPECT_EQ(edges_of_curves(parts), 20) << parts.size();
}

TEST(LineParts, of_nuts_chamfers_and_sides_of_two_edges_are_straight) {
  for (const int n : {4, 6, 8}) {
    Matrix2Xd nut = circle(n);
    nut.col(n) = nut.col(0);
    EXPECT_EQ(edges_of_curves(parts_of_loop(nut)), 0) << n;
  }
  const Matrix2Xd corners = circle(20);
  Matrix2Xd sides = corners.leftCols(1);
  for (int k = 0; k < 20; ++k)
    sides = one_after_the_other(sides,
                                along(corners.col(k), corners.col(k + 1), 2));
  sides.col(40) = sides.col(0);
  EXPECT_EQ(edges_of_curves(parts_of_loop(sides)), 0);
}

RC_GTEST_PROP(LineParts, of_uneven_vertices_with_noise_are_one_curve,
              (Random random)) {
  const Uniform step{1, 3}, noise{-1e-6, 1e-6};
  const int n = 40;
  std::vector<double> angle{0};
  for (int k = 0; k < n; ++k) angle.push_back(angle.back() + step(random));
  Matrix2Xd points(2, n + 1);
  for (int k = 0; k < n; ++k) {
    const double at = 2 * pi * angle[k] / angle[n];
    points.col(k) << 10 * std::cos(at) + noise(random),
        7 * std::sin(at) + noise(random);
  }
  points.col(n) = points.col(0);
  const std::vector<LinePart> parts = parts_of_loop(points);
  RC_ASSERT(parts.size() == 1u);
  RC_ASSERT(!parts[0].straight && parts[0].goes_on_before);
}

}  // namespace
}  // namespace ffcontact
