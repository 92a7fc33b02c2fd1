// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/short_edge_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cases.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Whose cells are those of the left part up to a share of the width.
FacetShare left_part(const Topology<2>& topology, double part) {
  const double width = topology.mesh.vertices.row(0).maxCoeff();
  Flags cell(topology.mesh.cell_count(), 0);
  for (int t = 0; t < count_of(cell); ++t)
    cell[t] = centroid_of(topology.mesh, t)[0] < part * width;
  return facet_share<2>(topology, cell, Flags(topology.facets.count(), 1));
}

bool have_a_cell_in_common(const Topology<2>& topology, int a, int b) {
  for (int t : topology.stars.cells_of(a))
    for (int other : topology.mesh.cells.col(t))
      if (other == b) return true;
  return false;
}

TEST(ShortEdgeLines, are_the_columns_of_stretched_cells) {
  constexpr int nx = 5, ny = 7;
  const Topology<2> topology =
      topology_of(rectangle(nx, ny, 10.0 * nx, 1.0 * ny));
  const RidgeLines lines = short_edge_lines(topology, whole_share<2>(topology));
  ASSERT_EQ(lines.count(), nx + 1);
  for (int l = 0; l < lines.count(); ++l) {
    EXPECT_EQ(lines.start[l + 1] - lines.start[l], ny + 1);
    for (int i = lines.start[l] + 1; i < lines.start[l + 1]; ++i) {
      const VectorOf<2> step = topology.mesh.vertices.col(lines.ridge[i]) -
                               topology.mesh.vertices.col(lines.ridge[i - 1]);
      EXPECT_EQ(step[0], 0);
      EXPECT_NEAR(std::abs(step[1]), 1, 1e-12);
    }
  }
}

TEST(ShortEdgeLines, are_single_vertices_where_cells_are_not_stretched) {
  const Topology<2> topology = topology_of(rectangle(6, 4, 6, 4));
  const RidgeLines lines = short_edge_lines(topology, whole_share<2>(topology));
  EXPECT_EQ(lines.count(), topology.ridges.count());
}

RC_GTEST_PROP(ShortEdgeLines, hold_each_vertex_once_and_touch_beside_each_other,
              (Random random)) {
  const double stretch = std::pow(10.0, Uniform{0, 3}(random));
  const Topology<2> topology =
      topology_of(irregular(9, 6, 9 * stretch, 6, random));
  const FacetShare share = left_part(topology, Uniform{0.3, 1.1}(random));
  const RidgeLines lines = short_edge_lines(topology, share);
  Flags found(topology.ridges.count(), 0);
  for (int v : lines.ridge) ++found[v];
  RC_ASSERT(found == share.ridge);
  for (int l = 0; l < lines.count(); ++l)
    for (int i = lines.start[l]; i < lines.start[l + 1]; ++i)
      for (int j = i + 1; j < lines.start[l + 1]; ++j)
        RC_ASSERT(have_a_cell_in_common(topology, lines.ridge[i],
                                        lines.ridge[j]) == (j == i + 1));
}

RC_GTEST_PROP(ShortEdgeLines, do_not_leave_the_cells_of_their_share,
              (Random random)) {
  const Topology<2> topology = topology_of(irregular(9, 6, 90, 6, random));
  const FacetShare share = left_part(topology, Uniform{0.2, 0.9}(random));
  const RidgeLines lines = short_edge_lines(topology, share);
  for (int l = 0; l < lines.count(); ++l) {
    if (lines.start[l + 1] - lines.start[l] == 1) continue;
    for (int i = lines.start[l]; i < lines.start[l + 1]; ++i)
      for (int t : topology.stars.cells_of(lines.ridge[i]))
        RC_ASSERT(share.cell[t]);
  }
}

}  // namespace
}  // namespace ffcontact
