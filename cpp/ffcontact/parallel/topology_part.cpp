// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/topology_part.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// Some of `count` things, numbered among themselves in their order.
class Selection {
 public:
  template <class List>
  Selection(int count, const List& chosen) : number_(count, -1) {
    for (int k : chosen) number_[k] = 0;
    for (int k = 0; k < count; ++k)
      if (number_[k] == 0) {
        number_[k] = count_of(chosen_);
        chosen_.push_back(k);
      }
  }

  const std::vector<int>& chosen() const { return chosen_; }
  int number(int k) const { return k < 0 ? -1 : number_[k]; }
  template <class Numbers>
  Numbers numbered(Numbers numbers) const {
    for (int& k : numbers.reshaped()) k = number(k);
    return numbers;
  }

 private:
  std::vector<int> number_, chosen_;
};

SolidMesh mesh_of(const SolidMesh& whole, const std::vector<int>& cells,
                  const Selection& vertices) {
  SolidMesh mesh;
  mesh.vertices = whole.vertices(Eigen::all, vertices.chosen());
  mesh.cells = vertices.numbered<Matrix<int, 4, Dynamic>>(
      whole.cells(Eigen::all, cells));
  mesh.boundary.resize(3, 0);
  mesh.boundary_label.resize(0);
  mesh.origin = whole.origin;
  return mesh;
}

Facets<3> faces_of(const Facets<3>& whole, const Selection& cells,
                   const Selection& vertices, const Selection& faces) {
  Facets<3> part;
  part.vertices =
      vertices.numbered<Matrix3Xi>(whole.vertices(Eigen::all, faces.chosen()));
  part.cells =
      cells.numbered<Matrix2Xi>(whole.cells(Eigen::all, faces.chosen()));
  for (auto beside : part.cells.colwise())
    if (beside[0] < 0) std::swap(beside[0], beside[1]);
  part.of_cell = faces.numbered<Matrix<int, 4, Dynamic>>(
      whole.of_cell(Eigen::all, cells.chosen()));
  part.eta = whole.eta(Eigen::all, cells.chosen());
  part.boundary_index.setConstant(part.vertices.cols(), -1);
  return part;
}

Ridges<3> edges_of(const Ridges<3>& whole, const Selection& vertices,
                   const Selection& faces) {
  const Matrix3Xi of_face = whole.of_facet(Eigen::all, faces.chosen());
  const Selection edges(whole.count(), of_face.reshaped());
  Ridges<3> part;
  part.vertices =
      vertices.numbered<Matrix2Xi>(whole.vertices(Eigen::all, edges.chosen()));
  part.of_facet = edges.numbered(of_face);
  part.facet_start = {0};
  for (int edge : edges.chosen()) {
    for (int of_whole : whole.facets_of(edge))
      if (const int face = faces.number(of_whole); face >= 0)
        part.facet.push_back(face);
    part.facet_start.push_back(count_of(part.facet));
    part.on_boundary.push_back(whole.on_boundary[edge]);
  }
  return part;
}

}  // namespace

int place_in(const std::vector<int>& list, int number) {
  return static_cast<int>(std::lower_bound(list.begin(), list.end(), number) -
                          list.begin());
}

TopologyPart part_of(const FacetTopology<3>& whole, std::vector<int> cells) {
  const auto& [mesh, faces, edges] = whole;
  const Selection chosen(mesh.cell_count(), cells),
      vertices(mesh.vertex_count(), mesh.cells(Eigen::all, cells).reshaped()),
      sides(faces.count(), faces.of_cell(Eigen::all, cells).reshaped());
  TopologyPart part;
  part.topology.mesh = mesh_of(mesh, cells, vertices);
  part.topology.facets = faces_of(faces, chosen, vertices, sides);
  part.topology.ridges = edges_of(edges, vertices, sides);
  part.cell = std::move(cells);
  part.face = sides.chosen();
  return part;
}

Flags edges_of_cells(const FacetTopology<3>& topology, const Flags& cell) {
  Flags edge(topology.ridges.count(), 0);
  for (int t = 0; t < topology.mesh.cell_count(); ++t)
    for (int k = 0; k < 4 && cell[t]; ++k)
      for (int e : topology.ridges.of_facet.col(topology.facets.of_cell(k, t)))
        edge[e] = 1;
  return edge;
}

std::vector<int> cells_at(const FacetTopology<3>& topology, const Flags& edge) {
  std::vector<int> cells;
  for (int t = 0; t < topology.mesh.cell_count(); ++t) {
    bool has_one = false;
    for (int k = 0; k < 4; ++k)
      for (int e : topology.ridges.of_facet.col(topology.facets.of_cell(k, t)))
        has_one = has_one || edge[e];
    if (has_one) cells.push_back(t);
  }
  return cells;
}

}  // namespace ffcontact
