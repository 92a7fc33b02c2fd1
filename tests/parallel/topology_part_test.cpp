// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/topology_part.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

std::vector<int> any_cells(int count, std::mt19937& random) {
  std::vector<int> cells;
  for (int t = 0; t < count; ++t)
    if (random() % 2 == 0) cells.push_back(t);
  if (cells.empty()) cells.push_back(0);
  return cells;
}

/// Corners, one column each.
template <class Corners>
MatrixXd places(const SolidMesh& mesh, const Corners& corners) {
  return mesh.vertices(Eigen::all, corners);
}

RC_GTEST_PROP(TopologyPart, has_what_the_whole_has, (Random random)) {
  const Topology<3> whole = topology_of(irregular_solid(random));
  const std::vector<int> cells = any_cells(whole.mesh.cell_count(), random);
  const TopologyPart part = part_of(whole, cells);
  const auto& [mesh, faces, edges, stars] = part.topology;
  RC_ASSERT(part.cell == cells);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    RC_ASSERT(places(mesh, mesh.cells.col(t)) ==
              places(whole.mesh, whole.mesh.cells.col(cells[t])));
    RC_ASSERT(faces.eta.col(t) == whole.facets.eta.col(cells[t]));
    for (int k = 0; k < 4; ++k)
      RC_ASSERT(part.face[faces.of_cell(k, t)] ==
                whole.facets.of_cell(k, cells[t]));
  }
  for (int f = 0; f < faces.count(); ++f) {
    const int of_whole = part.face[f];
    RC_ASSERT(places(mesh, faces.vertices.col(f)) ==
              places(whole.mesh, whole.facets.vertices.col(of_whole)));
    for (int t : whole.facets.cells.col(of_whole)) {
      const auto own = std::find(cells.begin(), cells.end(), t);
      if (own == cells.end()) continue;
      const auto number = static_cast<int>(own - cells.begin());
      RC_ASSERT((faces.cells.col(f).array() == number).any());
    }
    RC_ASSERT(faces.cells(0, f) >= 0);
    for (int k = 0; k < 3; ++k)
      RC_ASSERT(places(mesh, edges.vertices.col(edges.of_facet(k, f))) ==
                places(whole.mesh, whole.ridges.vertices.col(
                                       whole.ridges.of_facet(k, of_whole))));
  }
  RC_ASSERT(edges.facet.size() == 3u * faces.count());
  for (int e = 0; e < edges.count(); ++e)
    for (int i = edges.facet_start[e]; i < edges.facet_start[e + 1]; ++i)
      RC_ASSERT((edges.of_facet.col(edges.facet[i]).array() == e).any());
}

RC_GTEST_PROP(TopologyPart, around_cells_are_all_that_share_an_edge,
              (Random random)) {
  const Topology<3> whole = topology_of(irregular_solid(random));
  const SolidMesh& mesh = whole.mesh;
  const int chosen = static_cast<int>(random() % mesh.cell_count());
  std::vector<char> own(mesh.cell_count(), 0);
  own[chosen] = 1;
  const std::vector<int> around = cells_at(whole, edges_of_cells(whole, own));
  for (int t = 0; t < mesh.cell_count(); ++t) {
    int common = 0;
    for (int v : mesh.cells.col(t))
      common += (mesh.cells.col(chosen).array() == v).any();
    RC_ASSERT(std::binary_search(around.begin(), around.end(), t) ==
              (common >= 2));
  }
}

}  // namespace
}  // namespace ffcontact
