// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/cell_trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr int far = std::numeric_limits<int>::max() / 2;

template <int d>
int beyond(const Facets<d>& facets, int facet, int cell) {
  const Vector2i sides = facets.cells.col(facet);
  return sides[0] == cell ? sides[1] : sides[0];
}

/// Facets between each cell and the nearest root, by looking until nothing changes.
template <int d>
std::vector<int> distances(const Facets<d>& facets,
                           const std::vector<int>& roots) {
  std::vector<int> distance(facets.of_cell.cols(), far);
  for (int root : roots) distance[facets.cells(0, root)] = 1;
  for (bool changed = true; changed;) {
    changed = false;
    for (int f = 0; f < facets.count(); ++f)
      for (int k = 0; k < 2 && !facets.on_boundary(f); ++k) {
        int& own = distance[facets.cells(k, f)];
        const int other = distance[facets.cells(1 - k, f)] + 1;
        changed = changed || other < own;
        own = std::min(own, other);
      }
  }
  return distance;
}

/// The same along the trees, where each cell stands behind the one above it.
template <int d>
std::vector<int> depths(const Facets<d>& facets, const CellTrees& trees) {
  std::vector<int> depth(trees.facet.size(), far);
  for (int cell : trees.cell) {
    const int facet = trees.facet[cell];
    if (facet < 0) continue;
    const int above = beyond(facets, facet, cell);
    depth[cell] = above < 0 ? 1 : depth[above] + 1;
  }
  return depth;
}

template <int d>
void are_shortest(const SimplexMesh<d>& mesh) {
  const Facets<d> facets = facets_of(mesh);
  std::vector<int> roots;
  for (int f = 0; f < facets.count() && roots.size() < 2; ++f)
    if (facets.on_boundary(f)) roots.push_back(f);
  const CellTrees trees = cell_trees(facets, roots);
  RC_ASSERT(depths(facets, trees) == distances(facets, roots));
  RC_ASSERT(trees.without_root == std::vector<int>{mesh.cell_count()});
}

RC_GTEST_PROP(CellTrees, are_shortest_ways_to_roots, (Random random)) {
  are_shortest(irregular(4, 3, 4, 3, random));
  are_shortest(irregular_solid(random));
}

TEST(CellTrees, parts_without_roots_hang_below_their_first_cells) {
  Mesh mesh = rectangle(2, 1, 2, 1);
  Mesh two;
  two.vertices.resize(2, 2 * mesh.vertices.cols());
  two.vertices << mesh.vertices, mesh.vertices.colwise() + Vector2d(5, 0);
  two.cells.resize(3, 2 * mesh.cells.cols());
  two.cells << mesh.cells, mesh.cells.array() + mesh.vertex_count();
  two.boundary.resize(2, 2 * mesh.boundary.cols());
  two.boundary << mesh.boundary, mesh.boundary.array() + mesh.vertex_count();
  two.boundary_label.setOnes(two.boundary.cols());
  const Facets<2> facets = facets_of(two);
  const CellTrees trees = cell_trees(facets, {});
  EXPECT_EQ(trees.without_root, (std::vector<int>{0, 4, 8}));
  EXPECT_EQ(trees.cell[0], 0);
  EXPECT_EQ(trees.cell[4], 4);
  EXPECT_EQ(std::count(trees.facet.begin(), trees.facet.end(), -1), 2);
}

}  // namespace
}  // namespace ffcontact
