// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/mesh.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Volumes of larger meshes overflow.
constexpr double largest_coordinate = 1e75;

/// The facet opposite to local vertex k of a cell; outward.
template <int dim>
VectorOf<dim> outward_vector(const SimplexMesh<dim>& mesh, int cell, int k) {
  MatrixOf<dim> corners;
  for (int i = 0; i < dim; ++i)
    corners.col(i) = mesh.corner(cell, facet_corners<dim>[k][i]);
  return facet_vector(corners);
}

template <class Vertices>
void require_indices(const char* what, const Vertices& vertices, int count) {
  for (Index c = 0; c < vertices.cols(); ++c)
    for (const int v : vertices.col(c))
      if (v < 0 || v >= count)
        refuse(what, " ", c, " names vertex ", v, " of a mesh with ", count,
               " vertices");
}

template <int dim>
void require_vertices(const SimplexMesh<dim>& mesh) {
  using Words = MeshWords<dim>;
  const std::string facet = std::string("boundary ") + Words::facet;
  require_indices(Words::cell, mesh.cells, mesh.vertex_count());
  require_indices(facet.c_str(), mesh.boundary, mesh.vertex_count());
}

template <int dim>
void require_positive(const SimplexMesh<dim>& mesh) {
  using Words = MeshWords<dim>;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const double volume = signed_volume(mesh, t);
    if (!(volume > 0))
      refuse(Words::cell, " ", t, " has the ", Words::volume, " ", volume,
             ", not positive");
  }
}

/// Has it cells on both sides?
template <int dim>
bool is_inside(const SimplexMesh<dim>& mesh,
               const Matrix<int, dim, 1>& vertices) {
  const auto is_of_cell = [&](int t) {
    const Matrix<int, dim + 1, 1> cell = mesh.cells.col(t);
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](int v) { return (cell.array() == v).any(); });
  };
  int beside = 0;
  for (int t = 0; t < mesh.cell_count(); ++t) beside += is_of_cell(t);
  return beside > 1;
}

template <int dim>
[[noreturn]] void refuse_labels(const SimplexMesh<dim>& mesh, Index column,
                                int label, int other) {
  using Words = MeshWords<dim>;
  const Matrix<int, dim, 1> vertices = mesh.boundary.col(column);
  const std::string
      facet = std::string("the ") + Words::facet + " at " +
              in_words(mesh.origin +
                           facet_points<dim>(mesh, vertices).rowwise().mean(),
                       digits_of_figures),
      labels = label == other
                   ? " has the label " + std::to_string(label) + " twice"
                   : " has two labels, " + std::to_string(label) + " and " +
                         std::to_string(other);
  if (is_inside<dim>(mesh, vertices))
    refuse(facet, " inside the body", labels,
           ": if bodies touch there, their vertices were taken for the same, "
           "as FreeFEM's trunc and + do; take the mesh as gmshmesh reads it, "
           "or one mesh a body");
  if (label == other)
    refuse(facet, labels,
           ", and integrals over it count it twice: list it once");
  refuse(facet, labels,
         ": give it one of them (in gmsh, put it into one physical group)");
}

/// Which of several labels of a facet should count? Their order says nothing.
template <int dim>
void require_labelled_once(const SimplexMesh<dim>& mesh) {
  // vertices, sorted, and the column
  using Facet = std::array<int, dim + 1>;
  std::vector<Facet> facets(mesh.boundary.cols());
  for (int column = 0; column < count_of(facets); ++column) {
    Facet& facet = facets[column];
    std::copy_n(mesh.boundary.col(column).data(), dim, facet.begin());
    std::sort(facet.begin(), facet.begin() + dim);
    facet[dim] = column;
  }
  std::sort(facets.begin(), facets.end());
  for (std::size_t k = 1; k < facets.size(); ++k)
    if (std::equal(facets[k].begin(), facets[k].begin() + dim,
                   facets[k - 1].begin()))
      refuse_labels(mesh, facets[k][dim],
                    mesh.boundary_label[facets[k - 1][dim]],
                    mesh.boundary_label[facets[k][dim]]);
}

}  // namespace

template <int dim>
double boundary_measure(const SimplexMesh<dim>& mesh, Index column) {
  return facet_vector(facet_points<dim>(mesh, mesh.boundary.col(column)))
      .norm();
}

template <int dim>
double signed_volume(const SimplexMesh<dim>& mesh, int cell) {
  // base times height / dim
  const VectorOf<dim> height = mesh.corner(cell, 0) - mesh.corner(cell, dim);
  return outward_vector(mesh, cell, dim).dot(height) / dim;
}

template <int dim>
Matrix<double, dim, dim + 1> hat_gradients(const SimplexMesh<dim>& mesh,
                                           int cell) {
  Matrix<double, dim, dim + 1> gradients;
  for (int k = 0; k <= dim; ++k)
    gradients.col(k) = -outward_vector(mesh, cell, k);
  return gradients / (dim * signed_volume(mesh, cell));
}

template <int dim>
void require_valid(const SimplexMesh<dim>& mesh) {
  if (mesh.cell_count() == 0) refuse("the mesh has no ", MeshWords<dim>::cells);
  if (!mesh.vertices.allFinite())
    refuse("the mesh has a vertex whose coordinates are not finite");
  const double largest = max_norm(mesh.vertices);
  if (largest > largest_coordinate)
    refuse("the mesh has a vertex with the coordinate ", largest,
           ", whose square is no number any more");
  require_size("boundary_label", mesh.boundary_label.size(),
               mesh.boundary.cols());
  require_vertices(mesh);
  require_positive(mesh);
  require_labelled_once(mesh);
}

template double boundary_measure(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                 Index);
template double signed_volume(const SimplexMesh<FFCONTACT_DIMENSION>&, int);
template Matrix<double, FFCONTACT_DIMENSION, FFCONTACT_DIMENSION + 1>
hat_gradients(const SimplexMesh<FFCONTACT_DIMENSION>&, int);
template void require_valid(const SimplexMesh<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
