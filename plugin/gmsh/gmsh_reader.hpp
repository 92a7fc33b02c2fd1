// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact::plugin {

struct GmshMesh {
  Mesh mesh;  ///< triangles turned counter-clockwise, unused nodes left out
  VectorXi regions;  ///< one per triangle
};

/// Reads gmsh's format MSH 2.2 in text.
///
/// Labels and regions are the tags of physical curves and surfaces; where a file has no
/// physical curve (surface), those of its elementary entities. Edges of the boundary
/// that no line labels get 0; lines that are no edge of a triangle are left out. `shown`
/// is what the user calls the file.
/// @throws std::invalid_argument  if the file is spoilt, has no triangles, is not plane,
///                                has an edge or a triangle of two physical groups, or an
///                                element that is neither a point, nor a line of two, nor
///                                a triangle of three nodes
GmshMesh read_gmsh_mesh(const std::filesystem::path& file,
                        const std::string& shown);

/// Whether read_gmsh_mesh understands the format of a .msh file.
/// @throws std::invalid_argument  if it is no mesh of gmsh at all
bool is_readable_format(const std::filesystem::path& file);

/// Tag of the physical curve, or else of the physical surface, of that name, in a .msh
/// file of any version.
/// @throws std::invalid_argument  listing the names there are, if it is not one of them
int physical_tag(const std::filesystem::path& file, const std::string& name,
                 const std::string& shown);

}  // namespace ffcontact::plugin
