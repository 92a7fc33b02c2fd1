// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmsh/solid_msh_splitting.hpp"

#include <utility>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/splitting/solid_cell_split.hpp"

namespace ffcontact::plugin {

namespace {

SolidCellSplit split_of(const MshElement& cell, const MshFile& file,
                        const std::string& shown) {
  const int count = cell.type->corners;
  Matrix3Xd corners(3, count);
  for (int k = 0; k < count; ++k) corners.col(k) = file.nodes[cell.nodes[k]];
  SolidCellSplit split =
      solid_cell_split(corners, Map<const VectorXi>(cell.nodes.data(), count));
  if (split.tetrahedra.empty())
    refuse("the ", cell.type->name, " at ", place_of(cell, file), " of ", shown,
           " is flat or folded: no tetrahedra fill it");
  return split;
}

/// The tetrahedra of a cell follow those before.
void append_split(const MshElement& cell, const SolidCellSplit& split,
                  int middle, std::vector<MshElement>& tetrahedra) {
  for (const Vector4i& corners : split.tetrahedra) {
    MshElement tetrahedron{&simplex_type(3), cell.tags, {}};
    tetrahedron.nodes.fill(-1);
    for (int k = 0; k < 4; ++k)
      tetrahedron.nodes[k] =
          corners[k] == cell.type->corners ? middle : cell.nodes[corners[k]];
    tetrahedra.push_back(tetrahedron);
  }
}

}  // namespace

int split_solid_cells(MshFile& file, const std::string& shown) {
  std::vector<MshElement> result;
  const int node_count = count_of(file.nodes);
  for (const MshElement& cell : file.elements[3]) {
    if (cell.type->corners == 4) {
      result.push_back(cell);
      continue;
    }
    const SolidCellSplit split = split_of(cell, file, shown);
    append_split(cell, split, count_of(file.nodes), result);
    if (split.has_middle) file.nodes.push_back(centre_of(cell, file));
  }
  file.elements[3] = std::move(result);
  return count_of(file.nodes) - node_count;
}

}  // namespace ffcontact::plugin
