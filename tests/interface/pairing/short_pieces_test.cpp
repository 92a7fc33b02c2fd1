// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <vector>

#include "ffcontact/interface/pairing/common_refinement.hpp"
#include "support/bodies.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Cells of height 1 between the given places, the lowest at y.
Mesh cells(const std::vector<double>& x, double y) {
  const int n = static_cast<int>(x.size()) - 1;
  Mesh mesh = rectangle(n, 1, 1, 1);
  for (int v = 0; v < mesh.vertex_count(); ++v)
    mesh.vertices.col(v) << x[v % (n + 1)], y + v / (n + 1);
  return mesh;
}

/// All of the upper body's line faces edges of the lower one on the refinement, part by
/// part.
void expect_paired(const std::vector<double>& upper,
                   const std::vector<double>& lower, int parts) {
  const Bodies two =
      bodies({cells(upper, 1), cells(lower, 0)},
             {material(1, 0), material(1, 0)}, {{0, bottom, 1, top}});
  const CommonRefinement cut =
      common_refinement(two.problem.mesh, two.problem.edges, two.problem.line);
  EXPECT_TRUE(cut.exact);
  ASSERT_EQ(cut.line.edge_count(), parts);
  for (int e = 0; e < parts; ++e) {
    const Vector2d own = edge_vector(cut.mesh, cut.edges, cut.line.edge[e]);
    const Vector2d facing =
        edge_vector(cut.mesh, cut.edges, cut.line.opposite_edge[e]);
    EXPECT_LT((own + facing).norm(), 1e-12) << "part " << e;
  }
}

// An overlap of 9e-5 is a sliver for the long edge beside it (1.25), and none for the
// short one (0.75).
TEST(CommonRefinement, keeps_a_short_part_beside_a_longer_edge) {
  expect_paired({0, 1.25, 2, 3}, {-1, 0.05, 1.25009, 2.1, 4}, 6);
  expect_paired({0, 1, 1.75, 3}, {-1, 0.9, 1.74991, 2.95, 4}, 6);
}

}  // namespace
}  // namespace ffcontact
