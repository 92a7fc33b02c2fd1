// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// The vertices along one edge, from its first to its second, by their places: from 0 at
/// the first to 1 at the second.
using CutEdge = std::map<double, int>;

/// Edges of a mesh that are cut, with the vertices at their cuts and ends. New vertices
/// have the numbers after those of the mesh, edge by edge.
struct EdgeCuts {
  std::map<int, CutEdge> of_edge;

  /// @param place  of a cut, or within 1e-10 of one
  int vertex_at(int edge, double place) const;
  /// Whether a new vertex is on an edge.
  bool lies_on(int vertex, int edge) const;
};

/// Cuts at the ends of pieces on both of their edges, where they are no vertices.
EdgeCuts edge_cuts(const Mesh& mesh, const Edges& edges,
                   const ContactLine& line,
                   const std::vector<FacingPiece>& pieces);

}  // namespace ffcontact
