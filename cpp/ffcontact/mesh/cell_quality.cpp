// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/cell_quality.hpp"

#include <algorithm>
#include <cmath>

namespace ffcontact {

namespace {

template <int dim>
double longest_edge(const SimplexMesh<dim>& mesh, int cell) {
  double longest = 0;
  for (int i = 0; i < dim; ++i)
    for (int j = i + 1; j <= dim; ++j)
      longest = std::max(longest,
                         (mesh.corner(cell, j) - mesh.corner(cell, i)).norm());
  return longest;
}

/// 1/r is the sum of the inverse heights, which the gradients of the hats are.
template <int dim>
double inscribed_radius(const SimplexMesh<dim>& mesh, int cell) {
  return 1 / hat_gradients(mesh, cell).colwise().norm().sum();
}

}  // namespace

template <int dim>
VectorXd cell_quality(const SimplexMesh<dim>& mesh) {
  const double regular = 1 / std::sqrt(dim == 2 ? 12.0 : 24.0);
  return VectorXd::NullaryExpr(mesh.cells.cols(), [&](int t) {
    return inscribed_radius(mesh, t) / (regular * longest_edge(mesh, t));
  });
}

template VectorXd cell_quality(const SimplexMesh<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
