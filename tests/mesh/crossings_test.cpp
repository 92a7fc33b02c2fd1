// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/crossings.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

double share(const Mesh& mesh) {
  return crossing_share(mesh, 0, mesh.vertex_count());
}

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

/// n x n squares whose diagonals alternate, as FreeFEM's square(n, n, flags=1) has them.
Mesh alternating(int n) {
  Mesh mesh = rectangle(n, n, 1, 1);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1,
                t = 2 * (j * n + i);
      if ((i + j) % 2 == 0) {
        mesh.cells.col(t) << a, b, d;
        mesh.cells.col(t + 1) << a, d, c;
      } else {
        mesh.cells.col(t) << a, b, c;
        mesh.cells.col(t + 1) << b, d, c;
      }
    }
  return mesh;
}

TEST(CrossingShare, is_that_of_quadrangles_cut_by_both_diagonals) {
  Matrix<double, 2, 4> corners;
  corners << 0, 4, 4, 0, 0, 0, 4, 2;  // diagonals cross at (4/3, 4/3)
  const Vector2d crossing(4.0 / 3, 4.0 / 3);
  EXPECT_EQ(share(four_triangles(corners, crossing)), 1);
  EXPECT_EQ(share(four_triangles(corners, {1.4, 1.3})), 0);
}

TEST(CrossingShare, is_a_half_where_diagonals_alternate) {
  for (int n : {4, 5, 6, 20}) EXPECT_NEAR(share(alternating(n)), 0.5, 0.06);
  EXPECT_EQ(crossing_share(alternating(4), 0, 6), 0);  // the lowest row
}

TEST(CrossingShare, is_none_of_other_meshes) {
  Random random(2);
  EXPECT_EQ(share(rectangle(6, 5, 3, 2)), 0);
  EXPECT_EQ(share(irregular(6, 5, 3, 2, random)), 0);
  EXPECT_EQ(share(rectangle(1, 1, 1, 1)), 0);  // nothing is inside
}

}  // namespace
}  // namespace ffcontact
