// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// Bodies in contact, cut so that their facing traces match.
///
/// Every contact edge and every edge it faces is cut where the pieces of the line end,
/// and its triangle becomes the fan of triangles between the pieces and the opposite
/// vertex. Vertices of both bodies that all but meet, within 1e-4 of the shorter edge,
/// face each other: `exact` is then false, and the forces on the opposite body are off by
/// as little. Functions that are linear on the old triangles are linear on the new ones.
/// Old vertices and old nodes keep their numbers, new ones follow; the first triangle of
/// a fan keeps that of its parent. Contact directions are those of one end of an old edge
/// all along it.
struct CommonRefinement {
  Mesh mesh;
  Edges edges;
  ContactLine line;  ///< with matching traces
  VectorXi parent;   ///< old triangle of each triangle
  VectorXi
      /// old edge that each edge is a part of; -1 for the edges between the triangles of
      /// a fan
      parent_edge;
  VectorXi parent_contact_edge;  ///< old contact edge of each contact edge
  VectorXi parent_boundary;  ///< old column of Mesh::boundary of each column
  /// old vertices that each vertex lies between [vertices x old vertices]
  WeightsByNode vertex_weights;
  /// old contact nodes that each node lies between [p x old p]
  WeightsByNode node_weights;
  bool exact = true;

  /// Place of a vertex on an old edge: 0 at its first, 1 at its second vertex.
  double place(const Edges& old_edges, int vertex, int old_edge) const {
    return vertex_weights.coeff(vertex, old_edges.vertices(1, old_edge));
  }
};

/// @param line  with the pieces of facing_line
/// @throws std::invalid_argument  if two contact edges face the same part of an opposite
///                                edge, naming the place
CommonRefinement common_refinement(const Mesh& mesh, const Edges& edges,
                                   const ContactLine& line);

}  // namespace ffcontact
