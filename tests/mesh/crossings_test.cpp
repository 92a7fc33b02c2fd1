// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/crossings.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A quadrangle of these corners that a point parts into four triangles.
Mesh four_triangles(const Matrix<double, 2, 4>& corners,
                    const Vector2d& middle) {
  Mesh mesh;
  mesh.vertices.resize(2, 5);
  mesh.vertices << corners, middle;
  mesh.cells.resize(3, 4);
  for (int k = 0; k < 4; ++k) mesh.cells.col(k) << k, (k + 1) % 4, 4;
  return mesh;
}

TEST(CrossingShare, is_a_quarter_of_quadrangles_cut_by_both_diagonals) {
  Matrix<double, 2, 4> corners;
  corners << 0, 4, 4, 0, 0, 0, 4, 2;  // diagonals cross at (4/3, 4/3)
  EXPECT_EQ(crossing_share(four_triangles(corners, Vector2d(4, 4) / 3)), 0.25);
  EXPECT_EQ(crossing_share(four_triangles(corners, {1.4, 1.3})), 0);
}

TEST(CrossingShare, is_none_of_other_meshes) {
  Random random(2);
  EXPECT_EQ(crossing_share(rectangle(6, 5, 3, 2)), 0);
  EXPECT_EQ(crossing_share(irregular(6, 5, 3, 2, random)), 0);
}

}  // namespace
}  // namespace ffcontact
