// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/incompressibility.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

constexpr int most_asked = 2000;  // vertices
constexpr double misfit = 1e-6, least_told = 1e-3;

template <int dim>
using Block = Matrix<double, dim, dim>;

/// N of the edges of some vertices.
template <int dim>
using EdgeBlocks = std::map<std::pair<int, int>, Block<dim>>;

template <int dim>
void add_cell(const SimplexMesh<dim>& mesh, int t, int corner,
              EdgeBlocks<dim>& blocks) {
  const auto gradients = hat_gradients(mesh, t);
  const int i = mesh.cells(corner, t);
  for (int k = 0; k <= dim; ++k) {
    if (k == corner) continue;
    const auto [place, is_new] =
        blocks.try_emplace({i, mesh.cells(k, t)}, Block<dim>::Zero());
    place->second += signed_volume(mesh, t) * gradients.col(corner) *
                     gradients.col(k).transpose();
  }
}

/// One of so many vertices is asked.
int stride_of(int vertices) { return 1 + vertices / most_asked; }

bool is_asked(int vertex, int first, int end) {
  return vertex >= first && vertex < end &&
         (vertex - first) % stride_of(end - first) == 0;
}

template <int dim>
EdgeBlocks<dim> edge_blocks(const SimplexMesh<dim>& mesh, int first, int end) {
  EdgeBlocks<dim> blocks;
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k <= dim; ++k)
      if (is_asked(mesh.cells(k, t), first, end)) add_cell(mesh, t, k, blocks);
  return blocks;
}

template <int dim>
bool are_free(const ElasticSystem& system, int i, int j) {
  return free_axes<dim>(i, system.prescribed).cols() == dim &&
         free_axes<dim>(j, system.prescribed).cols() == dim;
}

template <int dim>
Block<dim> block_of(const RowMatrix& K, int i, int j) {
  return Block<dim>::NullaryExpr(
      [&](Index a, Index b) { return K.coeff(dim * i + a, dim * j + b); });
}

/// What lambda and G multiply, one column each.
template <int dim>
Matrix<double, dim * dim, 2> parts_of(const Block<dim>& N) {
  Matrix<double, dim * dim, 2> parts;
  const Block<dim> shear = N.transpose() + N.trace() * Block<dim>::Identity();
  parts << N.reshaped(), shear.reshaped();
  return parts;
}

/// Are the columns no multiples of each other?
template <class Solver>
bool tell(const Solver& solver) {
  const auto& R = solver.matrixQR();
  return std::abs(R(1, 1)) >= least_told * std::abs(R(0, 0));
}

/// lambda/G of one block, 0 where it does not tell.
template <int dim>
double bulk_over_shear(const Block<dim>& K, const Block<dim>& N) {
  const auto parts = parts_of<dim>(N);
  const auto solver = parts.colPivHouseholderQr();
  if (!tell(solver)) return 0;
  const Vector2d found = solver.solve(K.reshaped());
  const bool fits = (parts * found - K.reshaped()).norm() < misfit * K.norm();
  return fits && found[1] > 0 ? found[0] / found[1] : 0;
}

}  // namespace

template <int dim>
double largest_bulk_over_shear(const SimplexMesh<dim>& mesh,
                               const ElasticSystem& system, int first,
                               int end) {
  double largest = 0;
  for (const auto& [edge, N] : edge_blocks(mesh, first, end))
    if (const auto [i, j] = edge; are_free<dim>(system, i, j))
      largest = std::max(
          largest,
          bulk_over_shear<dim>(block_of<dim>(system.stiffness, i, j), N));
  return largest;
}

template double largest_bulk_over_shear(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                        const ElasticSystem&, int, int);

}  // namespace ffcontact
