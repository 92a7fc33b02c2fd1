// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "gmsh/gmsh_program.hpp"
#include "gmsh/gmsh_reader.hpp"
#include "gmsh/gmsh_run.hpp"
#include "gmsh/mesh_of_msh.hpp"
#include "gmsh/msh_splitting.hpp"
#include "gmsh/solid_msh_splitting.hpp"

namespace ffcontact::plugin {

GmshMesh<3> read_gmsh_solid(const std::filesystem::path& path,
                            const std::string& shown) {
  MshFile file = read_msh(path, shown, 3);
  take_each_cell_once(
      file, shown,
      ": does the geometry have physical surfaces but no physical "
      "volume? Plane meshes are read by gmshmesh");
  const std::vector<MshElement> before = file.elements[3];
  const int middles = split_solid_cells(file, shown);
  split_quadrangles(file, shown);
  MeshOfMsh<3> made(file, shown);
  std::string splitting = splitting_in_words(before, file.elements[3]);
  if (middles > 0)
    splitting +=
        ", with a new vertex in the middle of " + std::to_string(middles);
  return {made.mesh(), made.regions(), splitting};
}

GmshMesh<3> gmsh_solid(const std::filesystem::path& file) {
  const TemporaryFolder folder;
  return read_gmsh_solid(readable_msh(file, 3, folder), file.string());
}

}  // namespace ffcontact::plugin
