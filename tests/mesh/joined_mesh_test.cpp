// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/joined_mesh.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"

namespace ffcontact {
namespace {

using namespace test;

Mesh at(Mesh mesh, double x, double y) {
  mesh.vertices.colwise() += Vector2d(x, y);
  return mesh;
}

TEST(JoinedMesh, numbers_bodies_one_after_the_other) {
  Mesh first = rectangle(2, 1, 2, 1), second = rectangle(1, 3, 1, 3);
  second.boundary_label[0] = -5;
  const JoinedMesh joined = joined_mesh<2>({first, second, first});
  const Mesh& mesh = joined.mesh;
  ASSERT_EQ(joined.body_count(), 3);
  EXPECT_EQ(joined.first_vertex, (std::vector<int>{0, 6, 14, 20}));
  EXPECT_EQ(joined.first_cell, (std::vector<int>{0, 4, 10, 14}));
  EXPECT_EQ(joined.first_boundary, (std::vector<int>{0, 6, 14, 20}));
  require_valid(mesh);
  EXPECT_EQ(mesh.vertices.middleCols(6, 8), second.vertices);
  EXPECT_EQ(mesh.cells.middleCols(4, 6), (second.cells.array() + 6).matrix());
  EXPECT_EQ(mesh.cells.rightCols(4), (first.cells.array() + 14).matrix());
  EXPECT_EQ(mesh.boundary.middleCols(6, 8),
            (second.boundary.array() + 6).matrix());
}

TEST(JoinedMesh, shares_no_label_between_bodies) {
  Mesh first = rectangle(2, 1, 2, 1), second = first;
  first.boundary_label[1] = -5;
  second.boundary_label[2] = 9;
  const JoinedMesh joined = joined_mesh<2>({first, second});
  EXPECT_GT(joined.label(1, -5), joined.label(0, 9));
  for (int b = 0; b < 6; ++b) {
    EXPECT_EQ(joined.mesh.boundary_label[b],
              joined.label(0, first.boundary_label[b]));
    EXPECT_EQ(joined.mesh.boundary_label[6 + b],
              joined.label(1, second.boundary_label[b]));
  }
}

TEST(
    JoinedMesh,
    takes_coordinates_of_far_bodies_from_an_origin_near_them_without_rounding) {
  const Mesh first = at(rotated(rectangle(3, 2, 3, 2), 0.7), 1e6, -3e5),
             second = at(first, 2.5, 0.1);
  const Mesh joined = joined_mesh<2>({first, second}).mesh;
  EXPECT_LT(joined.vertices.cwiseAbs().maxCoeff(), 100);
  for (int v = 0; v < 12; ++v) {
    EXPECT_EQ(joined.place(v), first.vertices.col(v));
    EXPECT_EQ(joined.place(12 + v), second.vertices.col(v));
    EXPECT_EQ(joined.vertices.col(v) - joined.vertices.col(0),
              first.vertices.col(v) - first.vertices.col(0));
  }
}

TEST(JoinedMesh, leaves_the_coordinates_of_near_bodies_alone) {
  const Mesh first = at(rotated(rectangle(3, 2, 3, 2), 0.7), 5, -3);
  const Mesh joined = joined_mesh<2>({first}).mesh;
  EXPECT_EQ(joined.vertices, first.vertices);
  EXPECT_EQ(joined.origin, Vector2d::Zero());
}

}  // namespace
}  // namespace ffcontact
