// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// Some tetrahedra of a solid with their vertices, faces and edges, in the order of the
/// whole and with its normals. Of what lies beside them nothing is there: a face of which
/// one tetrahedron is missing has the other one alone, an edge the faces of the part
/// alone. Labels and stars are left out.
struct TopologyPart {
  Topology<3> topology;
  std::vector<int> cell, face;  ///< in the whole, ascending
};

/// The place of a number in an ascending list that has it, as those of TopologyPart.
int place_in(const std::vector<int>& list, int number);

/// @param cells  ascending
TopologyPart part_of(const FacetTopology<3>& whole, std::vector<int> cells);

/// 1 for each edge of one of these tetrahedra.
Flags edges_of_cells(const FacetTopology<3>& topology, const Flags& cell);

/// The tetrahedra with one of these edges, ascending.
std::vector<int> cells_at(const FacetTopology<3>& topology, const Flags& edge);

}  // namespace ffcontact
