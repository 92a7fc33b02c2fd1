// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Where the vertices and cells of one part are in the whole mesh; both empty: not known.
struct PartNumbers {
  std::vector<int> vertex, cell;

  bool empty() const { return vertex.empty() && cell.empty(); }
};

/// A mesh that was cut into parts along facets, put together again.
template <int dim>
struct MeshParts {
  SimplexMesh<dim> whole;
  std::vector<std::vector<int>> vertex,
      cell;  ///< in the whole of each of a part [part][own]
  /// columns of SimplexMesh::boundary likewise, -1 where the mesh was cut
  std::vector<std::vector<int>> boundary;

  int part_count() const { return static_cast<int>(vertex.size()); }
};

/// The whole mesh: vertices of several parts are the same where their numbers are, or,
/// without numbers, where their coordinates are, to the last bit. Without numbers vertices
/// and cells are in the order of the parts. What labelled facets two parts share is a cut
/// and no boundary.
/// @throws std::invalid_argument  if only some parts have numbers, these are not those of
///                                one mesh, or two vertices of a part without numbers are
///                                at one place
template <int dim>
MeshParts<dim> joined_parts(const std::vector<SimplexMesh<dim>>& parts,
                            const std::vector<PartNumbers>& numbers);

/// How many vertices, cells or boundary columns the whole has.
/// @param number  MeshParts::vertex, cell or boundary
int count_in_whole(const std::vector<std::vector<int>>& number);

/// Values of cells, columns of the boundary or vertices of the parts as those of the whole
/// [size x whole]; where several parts have one, that of the first. Those of number -1 are
/// dropped.
/// @param number  MeshParts::cell, boundary or vertex
MatrixXd of_whole(const std::vector<MatrixXd>& parts,
                  const std::vector<std::vector<int>>& number);

}  // namespace ffcontact
