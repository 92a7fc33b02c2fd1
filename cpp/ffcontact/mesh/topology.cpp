// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

Topology topology_of(Mesh mesh) {
  Topology topology{std::move(mesh), {}, {}};
  topology.edges = edges_of(topology.mesh);
  topology.stars = stars_of(topology.mesh, topology.edges);
  return topology;
}

}  // namespace ffcontact
