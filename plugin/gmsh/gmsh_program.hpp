// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "gmsh/gmsh_reader.hpp"
#include "gmsh/gmsh_run.hpp"

// gmsh runs as a program of its own, not as libgmsh in FreeFEM's process: there `Exit;` in
// a geometry ends the script without a word (4.8.4), a crash takes it along, and loading
// the library takes as long (0.3 s for its 91 shared objects) as running the program (0.4).

namespace ffcontact::plugin {

/// A .msh file of any version (other than MSH 2.2 in text after a conversion by gmsh), or
/// the mesh that gmsh makes of a geometry (.geo, .brep, .step, ...) with the geometry's
/// own sizes.
/// @throws std::invalid_argument  if the file cannot be read, gmsh is missing or refuses,
///                                or as read_gmsh_mesh
GmshMesh<2> gmsh_mesh(const std::filesystem::path& file);
/// The same of a solid.
GmshMesh<3> gmsh_solid(const std::filesystem::path& file);

/// What to read for a file: itself, or what gmsh makes of it in the folder.
std::filesystem::path readable_msh(const std::filesystem::path& file, int dim,
                                   const TemporaryFolder& folder);

/// The mesh that gmsh makes of a geometry when its edges shall have the lengths `size`
/// [mm] at the vertices of `background`, a mesh of the same body.
/// @throws std::invalid_argument  as above, or if a size is not positive or the file is
///                                no geometry
GmshMesh<2> gmsh_mesh(const std::filesystem::path& geometry,
                      const Mesh& background, const Ref<const VectorXd>& size);

/// Tag of the physical curve, or else of the physical surface, of that name in a geometry
/// or a .msh file.
/// @throws std::invalid_argument  as above, or listing the names there are, if it is not
///                                one of them
int gmsh_label(const std::filesystem::path& file, const std::string& name);

}  // namespace ffcontact::plugin
