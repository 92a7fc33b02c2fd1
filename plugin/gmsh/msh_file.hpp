// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

struct MshElement {
  std::array<int, 2> tags;   ///< physical, elementary
  std::array<int, 4> nodes;  ///< places in MshFile::nodes, as many as it has
};

/// What a file of MSH 2.2 in text holds.
struct MshFile {
  std::vector<Vector3d> nodes;
  std::vector<MshElement> lines, triangles, tetrahedra;
};

/// @param dim    2: lines and triangles are understood, 3: tetrahedra too
/// @param shown  what the user calls the file
/// @throws std::invalid_argument  if the file is spoilt or has other elements
MshFile read_msh(const std::filesystem::path& file, const std::string& shown,
                 int dim);

/// The nodes of some elements as vertices, in the order of the file.
struct UsedNodes {
  std::vector<int> node;    ///< of each vertex
  std::vector<int> vertex;  ///< of each node, or -1
};
UsedNodes used_nodes(const MshFile& file,
                     const std::vector<MshElement>& elements, int corners);

}  // namespace ffcontact::plugin
