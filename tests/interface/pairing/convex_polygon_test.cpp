// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/convex_polygon.hpp"

#include <gtest/gtest.h>

#include "ffcontact/base/plane.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

ConvexPolygon random_triangle(Random& random) {
  ConvexPolygon corners = random_matrix(2, 3, random);
  if (polygon_area(corners) < 0) corners = corners.rowwise().reverse().eval();
  return corners;
}

bool holds(const ConvexPolygon& polygon, const Vector2d& x) {
  for (Index k = 0; k < polygon.cols(); ++k) {
    const Vector2d p = polygon.col(k),
                   q = polygon.col((k + 1) % polygon.cols());
    if (cross(q - p, x - p) < 0) return false;
  }
  return polygon.cols() > 0;
}

RC_GTEST_PROP(ConvexPolygon, parts_are_those_of_their_points, (Random random)) {
  const ConvexPolygon a = random_triangle(random), b = random_triangle(random),
                      both = intersection(a, b);
  const std::vector<ConvexPolygon> beyond = difference(a, b);
  double area = polygon_area(both);
  RC_ASSERT(std::abs(polygon_area(intersection(b, a)) - area) < 1e-14);
  for (const ConvexPolygon& piece : beyond) {
    RC_ASSERT(polygon_area(piece) > 0);
    area += polygon_area(piece);
  }
  RC_ASSERT(std::abs(polygon_area(a) - area) < 1e-14);
  for (int k = 0; k < 50; ++k) {
    const Vector2d x = random_vector(2, random);
    RC_ASSERT(holds(both, x) == (holds(a, x) && holds(b, x)));
    int pieces = 0;
    for (const ConvexPolygon& piece : beyond) pieces += holds(piece, x);
    RC_ASSERT(pieces == (holds(a, x) && !holds(b, x)));
  }
}

TEST(ConvexPolygon, of_equal_and_of_separate_triangles) {
  ConvexPolygon a(2, 3), b(2, 3);
  a << 0, 1, 0, 0, 0, 1;
  b << 2, 3, 2, 0, 0, 1;
  EXPECT_EQ(polygon_area(intersection(a, a)), 0.5);
  EXPECT_TRUE(difference(a, a).empty());
  EXPECT_EQ(polygon_area(intersection(a, b)), 0);
  ASSERT_EQ(difference(a, b).size(), 1u);
  EXPECT_EQ(polygon_area(difference(a, b)[0]), 0.5);
}

}  // namespace
}  // namespace ffcontact
