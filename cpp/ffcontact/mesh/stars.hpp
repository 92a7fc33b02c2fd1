// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/edges.hpp"

namespace ffcontact {

/// The stars of all vertices: the edges at a vertex (spokes) and the triangles between
/// them, counter-clockwise.
///
/// At an inner vertex triangle k lies between spoke k and spoke k + 1 (cyclic): m
/// triangles, m spokes. At a boundary vertex the first and the last spoke are boundary
/// edges: m triangles, m + 1 spokes.
struct Stars {
  std::vector<int> triangle_start,
      /// triangles of vertex v: triangle[triangle_start[v] .. triangle_start[v+1])
      triangle;
  std::vector<int> local;               ///< local number of v in each of them
  std::vector<int> spoke_start, spoke;  ///< spokes likewise

  int triangle_count(int vertex) const {
    return triangle_start[vertex + 1] - triangle_start[vertex];
  }
  Map<const VectorXi> triangles_of(int vertex) const {
    return {triangle.data() + triangle_start[vertex], triangle_count(vertex)};
  }
  int spoke_count(int vertex) const {
    return spoke_start[vertex + 1] - spoke_start[vertex];
  }
  bool on_boundary(int vertex) const {
    return spoke_count(vertex) != triangle_count(vertex);
  }
};

/// @throws std::invalid_argument  if the body touches itself in a single vertex (its star
///                                would fall apart)
Stars stars_of(const Mesh& mesh, const Edges& edges);

}  // namespace ffcontact
