// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/face_share.hpp"

#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/mesh/topology_part.hpp"

namespace ffcontact {

FaceShare whole_share(const SolidTopology& topology) {
  const Flags faces(topology.faces.count(), 1);
  return {Flags(topology.mesh.cell_count(), 1), faces,
          Flags(topology.edges.count(), 1), faces};
}

FaceShare face_share(const SolidTopology& topology, Flags cell, Flags counted) {
  FaceShare share;
  share.face.assign(topology.faces.count(), 0);
  for (int t = 0; t < topology.mesh.cell_count(); ++t)
    for (int f : topology.faces.of_cell.col(t))
      share.face[f] = share.face[f] || cell[t];
  share.edge = edges_of_cells(topology, cell);
  share.cell = std::move(cell);
  share.counted = std::move(counted);
  return share;
}

}  // namespace ffcontact
