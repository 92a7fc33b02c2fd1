// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/separate_bodies.hpp"

#include <gtest/gtest.h>

#include "ffcontact/mesh/joined_mesh.hpp"
#include "ffcontact/mesh/self_touch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

Mesh lifted(Mesh mesh, double by) {
  mesh.vertices.row(1).array() += by;
  return mesh;
}

RC_GTEST_PROP(SeparateBodies, are_those_that_a_mesh_was_joined_of,
              (Random random)) {
  const std::vector<Mesh> joined = {rectangle(3, 2, 3, 2),
                                    lifted(rectangle(2, 2, 3, 2), 2),
                                    lifted(rectangle(1, 1, 3, 2), 4)};
  const auto [mesh, number] = renumbered(joined_mesh(joined).mesh, random);
  const std::vector<SeparateBody> bodies = separate_bodies(mesh);
  RC_ASSERT(bodies.size() == 3);
  std::vector<int> cells;
  for (const SeparateBody& body : bodies) {
    require_valid(body.mesh);
    cells.push_back(body.mesh.cell_count());
    RC_ASSERT(body.mesh.vertices == mesh.vertices(Eigen::all, body.vertex));
    for (int t = 0; t < body.mesh.cell_count(); ++t)
      for (int k = 0; k < 3; ++k)
        RC_ASSERT(body.vertex[body.mesh.cells(k, t)] ==
                  mesh.cells(k, body.cell[t]));
    const Mesh& of = joined[body.mesh.cell_count() == 12  ? 0
                            : body.mesh.cell_count() == 8 ? 1
                                                          : 2];
    RC_ASSERT(body.mesh.boundary.cols() == of.boundary.cols());
    double length = 0;
    for (Index e = 0; e < body.mesh.boundary.cols(); ++e)
      length += boundary_measure(body.mesh, e);
    RC_ASSERT(std::abs(length - 10) < 1e-12);
  }
  std::sort(cells.begin(), cells.end());
  RC_ASSERT((cells == std::vector<int>{2, 8, 12}));
}

TEST(SeparateBodies, leave_out_vertices_of_no_triangle) {
  Mesh mesh = rectangle(2, 1, 2, 1);
  mesh.vertices.conservativeResize(Eigen::NoChange, 7);
  mesh.vertices.col(6) << 5, 5;
  const std::vector<SeparateBody> bodies = separate_bodies(mesh);
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_EQ(bodies[0].mesh.vertex_count(), 6);
}

/// A rectangle whose bottom and top meet at the place x = 1.
Mesh pinched(double off) {
  Mesh mesh = rectangle(2, 2, 2, 2);
  mesh.vertices.col(1) << 1, 0.5;
  mesh.vertices.col(7) << 1 + off, 0.5 + off;
  return mesh;
}

TEST(SelfTouch, is_found_where_a_vertex_is_on_an_edge_or_on_another_one) {
  EXPECT_FALSE(self_touch(rectangle(3, 2, 3, 2)));
  EXPECT_TRUE(self_touch(pinched(0)));
  EXPECT_TRUE(self_touch(pinched(1e-9)));
  EXPECT_FALSE(self_touch(pinched(1e-6)));
  Mesh on_edge = rectangle(2, 2, 2, 2);
  on_edge.vertices.col(7) << 0.5, 0;
  EXPECT_EQ(self_touch(on_edge), 7);
}

TEST(SelfTouch, is_the_same_in_any_direction) {
  for (int k = 0; k < 12; ++k) {
    EXPECT_TRUE(self_touch(rotated(pinched(0), k)));
    EXPECT_FALSE(self_touch(rotated(pinched(1e-6), k)));
  }
}

}  // namespace
}  // namespace ffcontact
