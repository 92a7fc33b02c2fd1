// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact::plugin {

template <int dim>
struct GmshMesh {
  /// cells turned to positive volumes, unused nodes left out
  SimplexMesh<dim> mesh;
  VectorXi regions;  ///< one per cell
  /// what was split, "120 quadrangles were split into 240 triangles", or nothing
  std::string splitting;
};

/// Reads gmsh's format MSH 2.2 in text. Quadrangles are split into triangles, hexahedra,
/// prisms and pyramids into tetrahedra, as solid_cell_split and
/// quadrangle_triangles say.
///
/// Labels and regions are the tags of physical curves and surfaces (of a solid: surfaces
/// and volumes); where a file has no physical curve (surface), those of its elementary
/// entities. Facets of the boundary that nothing labels get 0; lines (triangles) that are
/// no facet of a cell are left out. `shown` is what the user calls the file.
/// @throws std::invalid_argument  if the file is spoilt, has no cells, is not plane, has a
///                                facet or a cell of two physical groups, a flat or folded
///                                cell, or an element with curved edges
GmshMesh<2> read_gmsh_mesh(const std::filesystem::path& file,
                           const std::string& shown);
GmshMesh<3> read_gmsh_solid(const std::filesystem::path& file,
                            const std::string& shown);

/// Whether read_gmsh_mesh understands the format of a .msh file.
/// @throws std::invalid_argument  if it is no mesh of gmsh at all
bool is_readable_format(const std::filesystem::path& file);

/// The number of a physical name in a .msh file of any version: of a curve, or else of a
/// surface; where volumes have names, of a surface, or else of a volume.
/// @throws std::invalid_argument  listing the names there are, if it is not one of them
int physical_tag(const std::filesystem::path& file, const std::string& name,
                 const std::string& shown);

}  // namespace ffcontact::plugin
