// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
//
#include "gmsh/gmsh_model.hpp"
#include "gmsh/msh_file.hpp"

namespace ffcontact::plugin {

namespace {

template <int size>
Matrix<int, size, Dynamic> vertices_of(const std::vector<MshElement>& elements,
                                       const UsedNodes& used) {
  Matrix<int, size, Dynamic> result(size, count_of(elements));
  for (int e = 0; e < count_of(elements); ++e) {
    if (elements[e].type->corners != size)
      refuse("gmsh has made ", elements[e].type->names,
             ": do its own options (~/.gmshrc) recombine?");
    for (int k = 0; k < size; ++k) {
      result(k, e) = used.vertex[elements[e].nodes[k]];
      if (result(k, e) < 0)
        refuse("gmsh has left a part of the surface without tetrahedra");
    }
  }
  return result;
}

/// Elementary entities from 0 on.
std::vector<int> entities_of(const std::vector<MshElement>& elements) {
  std::vector<int> entities;
  for (const MshElement& element : elements)
    entities.push_back(element.tags[1] - 1);
  return entities;
}

void turn_outside_out(SolidMesh& mesh) {
  for (int t = 0; t < mesh.cell_count(); ++t)
    if (signed_volume(mesh, t) < 0)
      std::swap(mesh.cells(2, t), mesh.cells(3, t));
}

}  // namespace

ModelMesh read_gmsh_model(const std::filesystem::path& path, double scale) {
  const MshFile file = read_msh(path, "the mesh of gmsh", 3);
  const auto& [points, lines, triangles, tetrahedra] = file.elements;
  if (tetrahedra.empty()) refuse("gmsh has filled the body with nothing");
  const UsedNodes used = used_nodes(file, tetrahedra);
  ModelMesh result;
  result.mesh.vertices.resize(3, count_of(used.node));
  for (int v = 0; v < count_of(used.node); ++v)
    result.mesh.vertices.col(v) = scale * file.nodes[used.node[v]];
  result.mesh.cells = vertices_of<4>(tetrahedra, used);
  turn_outside_out(result.mesh);
  result.mesh.boundary = vertices_of<3>(triangles, used);
  result.lines = vertices_of<2>(lines, used);
  result.part = entities_of(tetrahedra);
  result.patch = entities_of(triangles);
  result.curve = entities_of(lines);
  return result;
}

}  // namespace ffcontact::plugin
