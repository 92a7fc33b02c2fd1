// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// A type of elements with straight edges.
struct MshType {
  int number;  ///< gmsh's
  const char *name, *names;
  int dimension, corners;
};

struct MshElement {
  const MshType* type;
  std::array<int, 2> tags;  ///< physical, elementary
  /// places in MshFile::nodes, as many as the type has, then -1
  std::array<int, 8> nodes;
};

/// What a file of MSH 2.2 in text holds.
struct MshFile {
  int dim;  ///< as asked for
  std::vector<Vector3d> nodes;
  /// by dimension: points are left out; edges; triangles and quadrangles; tetrahedra,
  /// hexahedra, prisms and pyramids
  std::array<std::vector<MshElement>, 4> elements;
};

/// The triangle or the tetrahedron.
const MshType& simplex_type(int dimension);

/// @param dim    2: elements of a solid are refused
/// @param shown  what the user calls the file
/// @throws std::invalid_argument  if the file is spoilt or has other elements
MshFile read_msh(const std::filesystem::path& file, const std::string& shown,
                 int dim);

/// The mean of its nodes.
Vector3d centre_of(const MshElement& element, const MshFile& file);
/// The same for messages: "(0.5, 1)".
std::string place_of(const MshElement& element, const MshFile& file);

/// The nodes of some elements as vertices, in the order of the file.
struct UsedNodes {
  std::vector<int> node;    ///< of each vertex
  std::vector<int> vertex;  ///< of each node, or -1
};
UsedNodes used_nodes(const MshFile& file,
                     const std::vector<MshElement>& elements);

}  // namespace ffcontact::plugin
