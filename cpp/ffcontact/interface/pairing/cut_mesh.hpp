// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/interface/pairing/edge_cuts.hpp"

namespace ffcontact {

/// A mesh with boundary edges cut, and with each cut edge its triangle into a fan between
/// the parts of the edge and the opposite vertex. The first triangle of a fan keeps the
/// number of its parent, the others follow the old ones.
struct CutMesh {
  Mesh mesh;
  VectorXi parent;           ///< old triangle of each triangle
  VectorXi parent_boundary;  ///< old column of Mesh::boundary of each column
  /// old vertices that each vertex lies between [vertices x old vertices]
  WeightsByNode vertex_weights;
};

CutMesh cut_mesh(const Mesh& mesh, const Edges& edges, const EdgeCuts& cuts);

}  // namespace ffcontact
