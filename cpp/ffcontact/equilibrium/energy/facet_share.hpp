// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/mesh/facet_topology.hpp"

namespace ffcontact {

/// What one of several descents has of a body: its own cells and, as a halo, those with
/// which they share a ridge. Values 1 and 0.
struct FacetShare {
  Flags cell;          ///< its own
  Flags facet, ridge;  ///< of its own cells
  Flags counted;       ///< facets whose part in a sum is this share's
};

/// All of it.
template <int d>
FacetShare whole_share(const FacetTopology<d>& topology) {
  const Flags facets(topology.facets.count(), 1);
  return {Flags(topology.mesh.cell_count(), 1), facets,
          Flags(topology.ridges.count(), 1), facets};
}

/// @param cell     its own
/// @param counted  facets of these
template <int d>
FacetShare facet_share(const FacetTopology<d>& topology, Flags cell,
                       Flags counted) {
  FacetShare share;
  share.facet.assign(topology.facets.count(), 0);
  share.ridge.assign(topology.ridges.count(), 0);
  for (int t = 0; t < topology.mesh.cell_count(); ++t)
    for (int f : topology.facets.of_cell.col(t))
      share.facet[f] = share.facet[f] || cell[t];
  for (int f = 0; f < topology.facets.count(); ++f)
    for (int e : topology.ridges.of_facet.col(f))
      share.ridge[e] = share.ridge[e] || share.facet[f];
  share.cell = std::move(cell);
  share.counted = std::move(counted);
  return share;
}

}  // namespace ffcontact
