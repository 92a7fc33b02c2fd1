// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/solid_topology.hpp"

#include <utility>

namespace ffcontact {

namespace {

SolidStars solid_stars(const SolidMesh& mesh) {
  SolidStars stars;
  stars.start.assign(mesh.vertex_count() + 1, 0);
  for (int v : mesh.cells.reshaped()) ++stars.start[v + 1];
  for (int v = 0; v < mesh.vertex_count(); ++v)
    stars.start[v + 1] += stars.start[v];
  stars.cell.resize(mesh.cells.size());
  stars.local.resize(mesh.cells.size());
  std::vector<int> next(stars.start.begin(), stars.start.end() - 1);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 4; ++k) {
      const int place = next[mesh.cells(k, t)]++;
      stars.cell[place] = t;
      stars.local[place] = k;
    }
  return stars;
}

}  // namespace

SolidTopology topology_of(SolidMesh mesh) {
  SolidTopology topology;
  topology.mesh = std::move(mesh);
  topology.faces = facets_of(topology.mesh);
  topology.edges = ridges_of(topology.mesh, topology.faces);
  topology.stars = solid_stars(topology.mesh);
  return topology;
}

}  // namespace ffcontact
