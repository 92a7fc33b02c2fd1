// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/separate_bodies.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/unions.hpp"

namespace ffcontact {

namespace {

/// The triangles of each body [body][triangle].
std::vector<std::vector<int>> cells_of_bodies(const Mesh& mesh) {
  const std::vector<int> body = body_of_each_vertex(mesh);
  std::vector<std::vector<int>> of_number(mesh.vertex_count()), bodies;
  for (int t = 0; t < mesh.cell_count(); ++t)
    of_number[body[mesh.cells(0, t)]].push_back(t);
  for (std::vector<int>& cells : of_number)
    if (!cells.empty()) bodies.push_back(std::move(cells));
  return bodies;
}

/// Numbers in the whole as numbers in the body.
template <int size>
Matrix<int, size, Dynamic> renumbered(
    const Matrix<int, size, Dynamic>& vertices,
    const std::vector<int>& number) {
  return vertices.unaryExpr([&](int v) { return number[v]; });
}

/// Bodies cut out of a mesh one after the other.
class Cutting {
 public:
  explicit Cutting(const Mesh& whole)
      : whole_(whole), number_(whole.vertex_count(), -1) {}

  SeparateBody body(std::vector<int> cells) {
    SeparateBody body;
    number_vertices(cells, body.vertex);
    body.mesh.origin = whole_.origin;
    body.mesh.vertices = whole_.vertices(Eigen::all, body.vertex);
    body.mesh.cells = renumbered<3>(whole_.cells(Eigen::all, cells), number_);
    put_boundary(body.mesh);
    body.cell = std::move(cells);
    for (const int v : body.vertex) number_[v] = -1;
    return body;
  }

 private:
  void number_vertices(const std::vector<int>& cells,
                       std::vector<int>& vertex) {
    for (const int t : cells)
      for (const int v : whole_.cells.col(t)) number_[v] = 0;
    for (int v = 0; v < whole_.vertex_count(); ++v)
      if (number_[v] == 0) {
        number_[v] = count_of(vertex);
        vertex.push_back(v);
      }
  }

  void put_boundary(Mesh& mesh) const {
    std::vector<int> columns;
    for (int e = 0; e < whole_.boundary.cols(); ++e)
      if (number_[whole_.boundary(0, e)] >= 0) columns.push_back(e);
    mesh.boundary =
        renumbered<2>(whole_.boundary(Eigen::all, columns), number_);
    mesh.boundary_label = whole_.boundary_label(columns);
  }

  const Mesh& whole_;
  std::vector<int> number_;  ///< of each vertex in the body at hand, or -1
};

}  // namespace

template <int dim>
std::vector<int> body_of_each_vertex(const SimplexMesh<dim>& mesh) {
  Unions bodies(mesh.vertex_count());
  for (const auto& vertices : mesh.cells.colwise())
    for (int k = 1; k <= dim; ++k) bodies.join(vertices[0], vertices[k]);
  return bodies.numbers();
}

template std::vector<int> body_of_each_vertex(const Mesh&);
template std::vector<int> body_of_each_vertex(const SolidMesh&);

std::vector<SeparateBody> separate_bodies(const Mesh& mesh) {
  Cutting cutting(mesh);
  std::vector<SeparateBody> bodies;
  for (std::vector<int>& cells : cells_of_bodies(mesh))
    bodies.push_back(cutting.body(std::move(cells)));
  return bodies;
}

}  // namespace ffcontact
