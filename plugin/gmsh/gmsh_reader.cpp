// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh/gmsh_reader.hpp"

#include <fstream>
#include <iomanip>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
//
#include "gmsh/mesh_of_msh.hpp"
#include "gmsh/msh_splitting.hpp"

namespace ffcontact::plugin {

namespace {

using std::filesystem::path;

void require_plane(const MshFile& file, const UsedNodes& used,
                   const std::string& shown) {
  double extent = 0;
  for (const int node : used.node)
    extent =
        std::max(extent, file.nodes[node].head<2>().lpNorm<Eigen::Infinity>());
  const double z = file.nodes[used.node[0]].z();
  for (const int node : used.node)
    if (std::abs(file.nodes[node].z() - z) > 1e-9 * extent)
      refuse(shown, " is not plane: z is ", z, " and ", file.nodes[node].z(),
             " at two of its nodes");
}

struct PhysicalName {
  int dimension, tag;
  std::string name;
};

std::vector<PhysicalName> physical_names(const path& file) {
  std::ifstream stream(file);
  std::string word;
  while (stream >> word && word != "$PhysicalNames") {
  }
  int count = 0;
  stream >> count;
  std::vector<PhysicalName> names;
  PhysicalName next;
  while (count-- > 0 &&
         stream >> next.dimension >> next.tag >> std::quoted(next.name))
    names.push_back(next);
  return names;
}

}  // namespace

GmshMesh<2> read_gmsh_mesh(const path& path, const std::string& shown) {
  MshFile file = read_msh(path, shown, 2);
  take_each_cell_once(
      file, shown,
      ": does the geometry have physical curves but no physical "
      "surface?");
  const std::vector<MshElement> before = file.elements[2];
  split_quadrangles(file, shown);
  MeshOfMsh<2> made(file, shown);
  require_plane(file, made.used(), shown);
  return {made.mesh(), made.regions(),
          splitting_in_words(before, file.elements[2])};
}

bool is_readable_format(const path& file) {
  std::ifstream stream(file);
  std::string section;
  double version = 0;
  int binary = 0;
  if (!(stream >> section >> version >> binary) || section != "$MeshFormat")
    refuse(file.string(),
           " is not a mesh of gmsh: it does not start with $MeshFormat");
  return version >= 2 && version < 3 && binary == 0;
}

int physical_tag(const path& file, const std::string& name,
                 const std::string& shown) {
  const std::vector<PhysicalName> names = physical_names(file);
  int highest = 2;
  std::string listed;
  for (const PhysicalName& known : names) {
    highest = std::max(highest, known.dimension);
    listed += (listed.empty() ? "" : ", ") + known.name;
  }
  for (const int dimension : {highest - 1, highest})
    for (const PhysicalName& known : names)
      if (known.dimension == dimension && known.name == name) return known.tag;
  refuse(shown, " has no physical ",
         highest == 3 ? "surface or volume" : "curve or surface", " \"", name,
         "\"; ", names.empty() ? "it names none" : "its names are " + listed);
}

}  // namespace ffcontact::plugin
