// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/grid_level.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

NodeList all_below(int count) {
  NodeList numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

NodeList ascending(NodeList numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// D^-1 of what has something on its diagonal, 0 of the rest.
template <int size>
SingleBlock<size, size> inverse_of(const SingleBlock<size, size>& block) {
  const Matrix<double, size, size> D = block.template cast<double>();
  Matrix<double, size, 1> R = Matrix<double, size, 1>::Zero();
  for (int c = 0; c < size; ++c)
    if (D(c, c) > 0) R[c] = 1 / std::sqrt(D(c, c));
  Matrix<double, size, size> scaled = R.asDiagonal() * D * R.asDiagonal();
  scaled.diagonal().setOnes();
  return (R.asDiagonal() * scaled.inverse() * R.asDiagonal())
      .template cast<float>();
}

/// Numbers that have every frequency, the same on any machine.
VectorXf mixed_numbers(Index size) {
  return VectorXf::NullaryExpr(size, [](Index k) {
    const auto mixed = static_cast<std::uint32_t>(k) * 2654435761u;
    return static_cast<float>(mixed >> 8) / (1 << 23) - 1.0f;
  });
}

/// Numbers the columns of a row from `from` on.
void number_columns(const BlockPattern& A, int row, int from, NodeList& place) {
  for (int k = A.begin(row); k < A.end(row); ++k)
    place[A.column[k]] = from + k - A.begin(row);
}

void append_row(const BlockPattern& A, int row, NodeList& to) {
  to.insert(to.end(), A.column.begin() + A.begin(row),
            A.column.begin() + A.end(row));
}

}  // namespace

template <int dim, int size>
GridLevel<dim, size>::GridLevel(Grid<dim, size> grid, double threshold)
    : grid_(std::move(grid)), inverse_(grid_.A.rows()) {
  find_inverses(all_below(node_count()));
  largest_ = largest_eigenvalue();
  aggregates_ = strong_aggregates(grid_.A, grid_.part, threshold);
  find_patterns();
}

template <int dim, int size>
void GridLevel<dim, size>::find_inverses(const NodeList& nodes) {
#pragma omp parallel for
  for (int k = 0; k < count_of(nodes); ++k)
    inverse_[nodes[k]] = inverse_of(grid_.A.block(nodes[k], nodes[k]));
}

template <int dim, int size>
double GridLevel<dim, size>::largest_eigenvalue() const {
  // twelve steps are some 10 % low, on graded meshes more
  constexpr int steps = 12;
  constexpr double above = 1.2;
  VectorXf x = mixed_numbers(static_cast<Index>(size) * node_count());
  double value = 0;
  for (int step = 0; step < steps; ++step) {
    VectorXf next = product(grid_.A, x);
#pragma omp parallel for
    for (int i = 0; i < node_count(); ++i)
      block_of<size>(next, i) = inverse_[i] * block_of<size>(next, i).eval();
    const double length = next.cast<double>().norm();
    value = relative(length, x.cast<double>().norm());
    if (length == 0) return 1;
    x = next / static_cast<float>(length);
  }
  return above * value;
}

template <int dim, int size>
void GridLevel<dim, size>::find_patterns() {
  BlockPattern own;
  for (int aggregate : aggregates_.of_node) {
    if (aggregate >= 0) own.column.push_back(aggregate);
    own.first.push_back(count_of(own.column));
  }
  P_.pattern = product(grid_.A.pattern, own, aggregate_count());
  P_.value.resize(P_.pattern.column.size());
  AP_ = product(grid_.A.pattern, P_.pattern, aggregate_count());
  TransposedPattern transposed_P = transposed(P_.pattern, aggregate_count());
  R_.pattern = std::move(transposed_P.pattern);
  R_.value.resize(P_.value.size());
  place_in_R_ = std::move(transposed_P.place);
  tentative_.assign(node_count(), SingleBlock<size, coarse_size>::Zero());
}

/// Q_i - omega D^-1 (A Q)_i
template <int dim, int size>
void GridLevel<dim, size>::find_prolongation_row(int i, NodeList& place) {
  const auto omega = static_cast<float>(4 / (3 * largest_));
  const BlockRows<size, size>& A = grid_.A;
  const BlockPattern& row = P_.pattern;
  number_columns(row, i, row.begin(i), place);
  for (int k = row.begin(i); k < row.end(i); ++k) P_.value[k].setZero();
  for (int k = A.pattern.begin(i); k < A.pattern.end(i); ++k)
    if (const int j = A.pattern.column[k]; aggregates_.of_node[j] >= 0)
      P_.value[place[aggregates_.of_node[j]]] += A.value[k] * tentative_[j];
  for (int k = row.begin(i); k < row.end(i); ++k)
    P_.value[k] = -omega * (inverse_[i] * P_.value[k]).eval();
  if (aggregates_.of_node[i] >= 0)
    P_.value[place[aggregates_.of_node[i]]] += tentative_[i];
}

template <int dim, int size>
void GridLevel<dim, size>::find_prolongation(const NodeList& nodes) {
#pragma omp parallel
  {
    NodeList place(aggregate_count(), -1);
#pragma omp for
    for (int n = 0; n < count_of(nodes); ++n) {
      const int i = nodes[n];
      find_prolongation_row(i, place);
      for (int k = P_.pattern.begin(i); k < P_.pattern.end(i); ++k)
        R_.value[place_in_R_[k]] = P_.value[k].transpose();
    }
  }
}

/// (A P)_i, in the order of AP_.
template <int dim, int size>
void GridLevel<dim, size>::find_product_row(int i, NodeList& place,
                                            BlockOfP* row) const {
  number_columns(AP_, i, 0, place);
  const BlockRows<size, size>& A = grid_.A;
  for (int k = A.pattern.begin(i); k < A.pattern.end(i); ++k) {
    const int j = A.pattern.column[k];
    for (int l = P_.pattern.begin(j); l < P_.pattern.end(j); ++l)
      row[place[P_.pattern.column[l]]] += A.value[k] * P_.value[l];
  }
}

/// A_IJ = sum P_iI' (A P)_iJ, by rows.
/// @param products  rows of A P, and where each one begins
template <int dim, int size>
void GridLevel<dim, size>::find_coarse_row(
    int I, NodeList& place, const std::vector<BlockOfP>& products,
    const NodeList& first, CoarseMatrix& coarse) const {
  const BlockPattern& row = coarse.pattern;
  number_columns(row, I, row.begin(I), place);
  for (int k = row.begin(I); k < row.end(I); ++k) coarse.value[k].setZero();
  for (int k = R_.pattern.begin(I); k < R_.pattern.end(I); ++k) {
    const int i = R_.pattern.column[k];
    for (int l = AP_.begin(i); l < AP_.end(i); ++l)
      coarse.value[place[AP_.column[l]]].noalias() +=
          R_.value[k] * products[first[i] + l - AP_.begin(i)];
  }
}

/// @param needed  nodes with an entry in these rows of P', ascending
template <int dim, int size>
void GridLevel<dim, size>::find_coarse_rows(const NodeList& needed,
                                            const NodeList& aggregates,
                                            CoarseMatrix& coarse) const {
  NodeList first(node_count(), -1);
  int blocks = 0;
  for (int i : needed) {
    first[i] = blocks;
    blocks += AP_.end(i) - AP_.begin(i);
  }
  std::vector<BlockOfP> AP(blocks, BlockOfP::Zero());
#pragma omp parallel
  {
    NodeList place(aggregate_count(), -1);
#pragma omp for
    for (int n = 0; n < count_of(needed); ++n)
      find_product_row(needed[n], place, &AP[first[needed[n]]]);
#pragma omp for
    for (int n = 0; n < count_of(aggregates); ++n)
      find_coarse_row(aggregates[n], place, AP, first, coarse);
  }
}

template <int dim, int size>
auto GridLevel<dim, size>::coarse_grid() -> CoarseGrid {
  CoarseGrid coarse;
  coarse.A.pattern = product(R_.pattern, AP_, aggregate_count());
  coarse.A.value.resize(coarse.A.pattern.column.size());
  coarse.motions.resize(aggregate_count());
  for (const NodeList& members : aggregates_.members)
    coarse.part.push_back(grid_.part[members.front()]);
  const NodeList all = all_below(node_count());
  follow({all, all}, coarse);
  return coarse;
}

template <int dim, int size>
NodeList GridLevel<dim, size>::with_neighbours(const NodeList& nodes) const {
  if (count_of(nodes) == node_count()) return nodes;
  NodeList found = nodes;
  for (int i : nodes) append_row(grid_.A.pattern, i, found);
  return ascending(std::move(found));
}

/// With an entry in one of the nodes' rows of P.
template <int dim, int size>
NodeList GridLevel<dim, size>::aggregates_beside(const NodeList& nodes) const {
  if (count_of(nodes) == node_count()) return all_below(aggregate_count());
  NodeList found;
  for (int i : nodes) append_row(P_.pattern, i, found);
  return ascending(std::move(found));
}

/// @return nodes whose Q is new
template <int dim, int size>
NodeList GridLevel<dim, size>::find_bases(const NodeList& aggregates,
                                          CoarseGrid& coarse) {
#pragma omp parallel for
  for (int k = 0; k < count_of(aggregates); ++k) {
    const NodeList& members = aggregates_.members[aggregates[k]];
    const auto basis = aggregate_basis(grid_.motions, members);
    for (int n = 0; n < count_of(members); ++n)
      tentative_[members[n]] = basis.tentative[n];
    coarse.motions[aggregates[k]] = basis.motions;
  }
  NodeList nodes;
  for (int I : aggregates)
    nodes.insert(nodes.end(), aggregates_.members[I].begin(),
                 aggregates_.members[I].end());
  return ascending(std::move(nodes));
}

template <int dim, int size>
NodeList GridLevel<dim, size>::aggregates_of(const NodeList& nodes) const {
  NodeList found;
  for (int i : nodes)
    if (aggregates_.of_node[i] >= 0) found.push_back(aggregates_.of_node[i]);
  return ascending(std::move(found));
}

template <int dim, int size>
ChangedNodes GridLevel<dim, size>::refresh(const ChangedNodes& changed,
                                           CoarseGrid& coarse) {
  find_inverses(changed.rows);
  return follow(changed, coarse);
}

template <int dim, int size>
ChangedNodes GridLevel<dim, size>::follow(const ChangedNodes& changed,
                                          CoarseGrid& coarse) {
  ChangedNodes result;
  result.motions = aggregates_of(changed.motions);
  NodeList moved = with_neighbours(find_bases(result.motions, coarse));
  moved.insert(moved.end(), changed.rows.begin(), changed.rows.end());
  moved = ascending(std::move(moved));
  find_prolongation(moved);
  result.rows = aggregates_beside(with_neighbours(moved));
  NodeList needed;
  for (int I : result.rows) append_row(R_.pattern, I, needed);
  find_coarse_rows(ascending(std::move(needed)), result.rows, coarse.A);
  return result;
}

template <int dim, int size>
VectorXf GridLevel<dim, size>::smoothed(VectorXf& residual) const {
  constexpr double lower = 0.1;
  const double middle = (1 + lower) / 2 * largest_,
               half = (1 - lower) / 2 * largest_, sigma = middle / half,
               rho = 1 / (2 * sigma - 1 / sigma);
  const auto first = static_cast<float>(1 / middle),
             again = static_cast<float>(rho / sigma),
             second = static_cast<float>(2 * rho / half);
  VectorXf step(residual.size()), change(residual.size());
#pragma omp parallel for
  for (int i = 0; i < node_count(); ++i)
    block_of<size>(step, i) =
        first * (inverse_[i] * block_of<size>(residual, i));
#pragma omp parallel for
  for (int i = 0; i < node_count(); ++i) {
    auto left = block_of<size>(residual, i);
    left -= grid_.A.row_times(i, step);
    block_of<size>(change, i) =
        again * block_of<size>(step, i) + second * (inverse_[i] * left);
  }
  // the second step's part of the residual
#pragma omp parallel for
  for (int i = 0; i < node_count(); ++i)
    block_of<size>(residual, i) -= grid_.A.row_times(i, change);
  return step + change;
}

template <int dim, int size>
VectorXf GridLevel<dim, size>::residual(const VectorXf& right,
                                        const VectorXf& x) const {
  VectorXf left(right.size());
#pragma omp parallel for
  for (int i = 0; i < node_count(); ++i)
    block_of<size>(left, i) =
        block_of<size>(right, i) - grid_.A.row_times(i, x);
  return left;
}

template class GridLevel<3, 3>;
template class GridLevel<3, 6>;

}  // namespace ffcontact
