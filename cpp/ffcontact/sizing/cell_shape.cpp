// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/cell_shape.hpp"

#include <cmath>

namespace ffcontact {

namespace {

template <int dim>
double mean_of_squared_sides(const SimplexMesh<dim>& mesh, int cell) {
  constexpr int sides = dim * (dim + 1) / 2;
  double squares = 0;
  for (int i = 0; i < dim; ++i)
    for (int j = i + 1; j <= dim; ++j)
      squares += (mesh.corner(cell, j) - mesh.corner(cell, i)).squaredNorm();
  return squares / sides;
}

}  // namespace

template <int dim>
double regular_volume() {
  return dim == 2 ? std::sqrt(3.0) / 4 : std::sqrt(2.0) / 12;
}

template <int dim>
double size_of_volume(double volume) {
  const double cells = volume / regular_volume<dim>();
  return dim == 2 ? std::sqrt(cells) : std::cbrt(cells);
}

template <int dim>
VectorXd mean_edges(const SimplexMesh<dim>& mesh) {
  return VectorXd::NullaryExpr(mesh.cells.cols(), [&](int t) {
    return std::sqrt(mean_of_squared_sides(mesh, t));
  });
}

template <int dim>
double size_of_cell(const SimplexMesh<dim>& mesh, int cell) {
  return size_of_volume<dim>(signed_volume(mesh, cell));
}

template <int dim>
VectorXd shape_quality(const SimplexMesh<dim>& mesh) {
  const VectorXd sizes = VectorXd::NullaryExpr(
      mesh.cells.cols(), [&](int t) { return size_of_cell(mesh, t); });
  return sizes.cwiseQuotient(mean_edges(mesh));
}

template double regular_volume<FFCONTACT_DIMENSION>();
template double size_of_volume<FFCONTACT_DIMENSION>(double);
template double size_of_cell(const SimplexMesh<FFCONTACT_DIMENSION>&, int);
template VectorXd mean_edges(const SimplexMesh<FFCONTACT_DIMENSION>&);
template VectorXd shape_quality(const SimplexMesh<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
