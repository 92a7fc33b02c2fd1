// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/facets.hpp"

#include <array>
#include <string>
#include <vector>

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/mesh/sorted_parts.hpp"

namespace ffcontact {

namespace {

template <int dim>
using Corners = std::array<int, dim>;

/// One side of a cell, or one labelled facet (cell = -1), keyed by its sorted vertices.
template <int dim>
struct Side {
  Corners<dim> vertices;
  int cell;
  int local;  ///< opposite local vertex, or the column of SimplexMesh::boundary

  bool operator<(const Side& other) const {
    for (int i = 0; i < dim; ++i)
      if (vertices[i] != other.vertices[i])
        return vertices[i] < other.vertices[i];
    return cell > other.cell;  // labelled facets come last among equals
  }
};

/// Whether an odd number of exchanges puts them in ascending order.
template <class Vertices>
bool is_odd(const Vertices& vertices) {
  bool odd = false;
  for (auto a = vertices.begin(); a != vertices.end(); ++a)
    for (auto b = a + 1; b != vertices.end(); ++b) odd ^= *b < *a;
  return odd;
}

/// Vertices of the facet opposite to local vertex k; its vector points outward.
template <int dim>
Corners<dim> outward_corners(const SimplexMesh<dim>& mesh, int cell, int k) {
  Corners<dim> vertices;
  for (int i = 0; i < dim; ++i)
    vertices[i] = mesh.cells(facet_corners<dim>[k][i], cell);
  return vertices;
}

template <int dim>
Corners<dim> labelled_corners(const SimplexMesh<dim>& mesh, int column) {
  Corners<dim> vertices;
  for (int i = 0; i < dim; ++i) vertices[i] = mesh.boundary(i, column);
  return vertices;
}

template <int dim>
std::vector<Side<dim>> sides_of(const SimplexMesh<dim>& mesh) {
  std::vector<Side<dim>> sides;
  sides.reserve((dim + 1) * mesh.cells.cols() + mesh.boundary.cols());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k <= dim; ++k)
      sides.push_back({ascending(outward_corners(mesh, t, k)), t, k});
  for (int b = 0; b < mesh.boundary.cols(); ++b)
    sides.push_back({ascending(labelled_corners(mesh, b)), -1, b});
  return sides;
}

/// "edge between vertices 3 and 7", "face between vertices 3, 7 and 9".
template <int dim>
std::string side_in_words(const Side<dim>& side) {
  std::vector<std::string> vertices;
  for (int v : side.vertices) vertices.push_back(std::to_string(v));
  return MeshWords<dim>::facet + std::string(" between vertices ") +
         listed(vertices, " and ");
}

/// Facets made one after the other from their sorted sides.
template <int dim>
class Gathering {
 public:
  using Words = MeshWords<dim>;

  explicit Gathering(const SimplexMesh<dim>& mesh) : mesh_(mesh) {
    const Index cells = mesh.cells.cols(), most = (dim + 1) * cells;
    facets_.vertices.resize(dim, most);
    facets_.cells.resize(2, most);
    facets_.boundary_index.resize(most);
    facets_.of_cell.resize(dim + 1, cells);
    facets_.eta.resize(dim + 1, cells);
  }

  /// A new facet, in the order in which this side of it points outward.
  void begin(const Side<dim>& side) {
    if (side.cell < 0)
      refuse("labelled ", Words::facet, " ", side.local, " belongs to no ",
             Words::cell);
    const Corners<dim> corners = outward_corners(mesh_, side.cell, side.local);
    for (int i = 0; i < dim; ++i) facets_.vertices(i, count_) = corners[i];
    facets_.cells.col(count_) << side.cell, -1;
    facets_.boundary_index[count_] = -1;
    is_odd_ = is_odd(corners);
  }

  /// What else is known of the facet that was begun, its first side included.
  void add(const Side<dim>& side) {
    if (side.cell < 0) {
      facets_.boundary_index[count_] = side.local;
      return;
    }
    const bool first = side.cell == facets_.cells(0, count_);
    if (!first) add_second(side);
    facets_.of_cell(side.local, side.cell) = count_;
    facets_.eta(side.local, side.cell) = first ? 1 : -1;
  }

  void end(const Side<dim>& side) {
    if (facets_.on_boundary(count_) && facets_.boundary_index[count_] < 0)
      refuse("the boundary ", side_in_words(side), " has no label");
    ++count_;
  }

  Facets<dim> facets() && {
    facets_.vertices.conservativeResize(Eigen::NoChange, count_);
    facets_.cells.conservativeResize(Eigen::NoChange, count_);
    facets_.boundary_index.conservativeResize(count_);
    return std::move(facets_);
  }

 private:
  void add_second(const Side<dim>& side) {
    const Corners<dim> corners = outward_corners(mesh_, side.cell, side.local);
    const bool on_same_side = is_odd(corners) == is_odd_;
    if (on_same_side || !facets_.on_boundary(count_))
      refuse("the ", side_in_words(side), " has ", Words::cells,
             " that overlap");
    facets_.cells(1, count_) = side.cell;
  }

  const SimplexMesh<dim>& mesh_;
  Facets<dim> facets_;
  int count_ = 0;
  bool is_odd_ = false;  ///< of the facet that was begun
};

template <int dim>
VectorOf<dim> vector_of(const SimplexMesh<dim>& mesh, const Facets<dim>& facets,
                        int facet) {
  return facet_vector(facet_points(mesh, facets, facet));
}

}  // namespace

template <int dim>
Facets<dim> facets_of(const SimplexMesh<dim>& mesh) {
  const std::vector<Side<dim>> sides =
      sorted_parts(sides_of(mesh), mesh.vertex_count());
  Gathering<dim> gathering(mesh);
  for (auto side = sides.begin(); side != sides.end();) {
    const Side<dim>& first = *side;
    gathering.begin(first);
    for (; side != sides.end() && side->vertices == first.vertices; ++side)
      gathering.add(*side);
    gathering.end(first);
  }
  return std::move(gathering).facets();
}

template <int dim>
double facet_measure(const SimplexMesh<dim>& mesh, const Facets<dim>& facets,
                     int facet) {
  return vector_of(mesh, facets, facet).norm();
}

template <int dim>
VectorOf<dim> facet_normal(const SimplexMesh<dim>& mesh,
                           const Facets<dim>& facets, int facet) {
  return vector_of(mesh, facets, facet).normalized();
}

template Facets<FFCONTACT_DIMENSION> facets_of(
    const SimplexMesh<FFCONTACT_DIMENSION>&);
template double facet_measure(const SimplexMesh<FFCONTACT_DIMENSION>&,
                              const Facets<FFCONTACT_DIMENSION>&, int);
template Matrix<double, FFCONTACT_DIMENSION, 1> facet_normal(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const Facets<FFCONTACT_DIMENSION>&,
    int);

}  // namespace ffcontact
