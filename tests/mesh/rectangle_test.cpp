// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/rectangle.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "ffcontact/mesh/topology.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(Rectangle, is_cut_from_lower_left_to_upper_right) {
  const Mesh mesh = rectangle({4, 3}, {8, 3});
  require_valid(mesh);
  EXPECT_EQ(mesh.vertex_count(), 20);
  EXPECT_EQ(mesh.cell_count(), 24);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    EXPECT_DOUBLE_EQ(signed_area(mesh, t), 1);
    int diagonals = 0;
    for (int k = 0; k < 3; ++k)
      diagonals +=
          (mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k)).cwiseAbs() ==
              Vector2d(2, 1) &&
          (mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k)).prod() > 0;
    EXPECT_EQ(diagonals, 1);
  }
}

/// Around the body, with it on the left, each side with its label.
TEST(Rectangle, has_its_sides_in_order) {
  const Vector2d size(8, 3);
  const Mesh mesh = rectangle({4, 3}, size);
  ASSERT_EQ(mesh.boundary.cols(), 14);
  double area = 0;
  for (Index e = 0; e < 14; ++e) {
    EXPECT_EQ(mesh.boundary(1, e), mesh.boundary(0, (e + 1) % 14));
    const Vector2d a = mesh.vertices.col(mesh.boundary(0, e)),
                   b = mesh.vertices.col(mesh.boundary(1, e));
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    const int label = mesh.boundary_label[e], across = label % 2;
    const double side = label == 1 || label == 4 ? 0 : size[across];
    EXPECT_EQ(a[across], side);
    EXPECT_EQ(b[across], side);
  }
  EXPECT_DOUBLE_EQ(area, 24);
}

TEST(Rectangle, without_cells_or_size_is_refused) {
  const double inf = std::numeric_limits<double>::infinity();
  const auto said = [](const Vector2i& cells, const Vector2d& size) {
    return refusal([&] { rectangle(cells, size); });
  };
  EXPECT_TRUE(says(said({0, 3}, {1, 1}), "at least one cell each way, got 0"));
  EXPECT_TRUE(says(said({3, -1}, {1, 1}), "at least one cell"));
  EXPECT_TRUE(says(said({1, 1}, {1, 0}), "positive, got 1 and 0"));
  EXPECT_TRUE(says(said({1, 1}, {inf, 1}), "positive"));
  EXPECT_EQ(said({1, 1}, {1e-9, 1}), "accepted");
}

}  // namespace
}  // namespace ffcontact
