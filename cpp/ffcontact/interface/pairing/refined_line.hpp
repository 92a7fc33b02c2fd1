// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/interface/pairing/edge_cuts.hpp"

namespace ffcontact {

/// A contact line on the mesh whose edges are cut where its pieces end: each piece is a
/// contact edge and faces a whole edge. Old nodes keep their numbers, new ones follow, with
/// contact directions between those of the ends of their old edge. A vertex that
/// faces one vertex on its left and another one on its right, as in front of a joint
/// between two bodies, is two nodes.
struct RefinedLine {
  ContactLine line;
  VectorXi parent;  ///< old contact edge of each contact edge
  /// old contact nodes that each node lies between [p x old p]
  WeightsByNode node_weights;
};

/// @param mesh, edges  with the edges cut
/// @param old_edges, old_line  before
/// @throws std::invalid_argument  if two contact edges face the same part of an opposite
///                                edge, naming the place
RefinedLine refined_line(const Mesh& mesh, const Edges& edges,
                         const Edges& old_edges, const ContactLine& old_line,
                         const std::vector<FacingPiece>& pieces,
                         const EdgeCuts& cuts);

}  // namespace ffcontact
