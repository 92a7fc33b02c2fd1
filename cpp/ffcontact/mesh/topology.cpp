// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/topology.hpp"

#include <utility>

namespace ffcontact {

namespace {

template <int d>
Stars stars_of(const SimplexMesh<d>& mesh) {
  Stars stars;
  stars.start.assign(mesh.vertex_count() + 1, 0);
  for (int v : mesh.cells.reshaped()) ++stars.start[v + 1];
  for (int v = 0; v < mesh.vertex_count(); ++v)
    stars.start[v + 1] += stars.start[v];
  stars.cell.resize(mesh.cells.size());
  stars.local.resize(mesh.cells.size());
  std::vector<int> next(stars.start.begin(), stars.start.end() - 1);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k <= d; ++k) {
      const int place = next[mesh.cells(k, t)]++;
      stars.cell[place] = t;
      stars.local[place] = k;
    }
  return stars;
}

}  // namespace

template <int d>
Topology<d> topology_of(SimplexMesh<d> mesh) {
  Facets<d> facets = facets_of(mesh);
  return topology_of<d>(std::move(mesh), std::move(facets));
}

template <int d>
Topology<d> topology_of(SimplexMesh<d> mesh, Facets<d> facets) {
  Topology<d> topology{std::move(mesh), std::move(facets), {}, {}};
  topology.ridges = ridges_of(topology.mesh, topology.facets);
  topology.stars = stars_of(topology.mesh);
  return topology;
}

template Topology<FFCONTACT_DIMENSION> topology_of(
    SimplexMesh<FFCONTACT_DIMENSION>, Facets<FFCONTACT_DIMENSION>);
template Topology<FFCONTACT_DIMENSION> topology_of(
    SimplexMesh<FFCONTACT_DIMENSION>);

}  // namespace ffcontact
