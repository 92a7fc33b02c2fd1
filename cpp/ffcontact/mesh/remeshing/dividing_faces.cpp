// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/dividing_faces.hpp"

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/unions.hpp"

namespace ffcontact {

namespace {

bool divides(const Facets<3>& faces, const VectorXi& regions, int f) {
  const auto cells = faces.cells.col(f);
  return cells[1] < 0 || faces.boundary_index[f] >= 0 ||
         regions[cells[0]] != regions[cells[1]];
}

/// The part of each cell.
std::vector<int> parts_of(const SolidMesh& mesh, const Facets<3>& faces,
                          const VectorXi& regions) {
  Unions parts(mesh.cell_count());
  for (int f = 0; f < faces.count(); ++f)
    if (!divides(faces, regions, f))
      parts.join(faces.cells(0, f), faces.cells(1, f));
  return parts.numbers();
}

}  // namespace

DividingFaces dividing_faces(const SolidMesh& mesh, const Facets<3>& faces,
                             const VectorXi& regions) {
  require_size("regions", regions.size(), mesh.cell_count());
  const std::vector<int> part = parts_of(mesh, faces, regions);
  DividingFaces result;
  for (int t = 0; t < mesh.cell_count(); ++t)
    if (part[t] == result.part_count()) result.region.push_back(regions[t]);
  std::vector<Vector2i> sides;
  for (int f = 0; f < faces.count(); ++f) {
    if (!divides(faces, regions, f)) continue;
    const int first = faces.cells(0, f), second = faces.cells(1, f);
    sides.emplace_back(part[first], second < 0 ? -1 : part[second]);
    if (sides.back()[0] == sides.back()[1])
      refuse("a face inside the body has the label ",
             mesh.boundary_label[faces.boundary_index[f]],
             " and does not part it in two: such faces cannot be meshed anew, "
             "remove them from the boundary");
    result.face.push_back(f);
    result.boundary.push_back(faces.boundary_index[f]);
  }
  result.parts.resize(2, result.count());
  for (int k = 0; k < result.count(); ++k) result.parts.col(k) = sides[k];
  return result;
}

}  // namespace ffcontact
