// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/coarsening.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "ffcontact/base/packed.hpp"

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

/// Numbers the columns of a row from `from` on.
void number_columns(const BlockPattern& A, int row, int from, NodeList& place) {
  for (int k = A.begin(row); k < A.end(row); ++k)
    place[A.column[k]] = from + k - A.begin(row);
}

void append_row(const BlockPattern& A, int row, NodeList& to) {
  to.insert(to.end(), A.column.begin() + A.begin(row),
            A.column.begin() + A.end(row));
}

NodeList with_neighbours(const BlockPattern& A, const NodeList& nodes) {
  if (count_of(nodes) == A.rows()) return nodes;
  NodeList found = nodes;
  for (int i : nodes) append_row(A, i, found);
  return ascending(std::move(found));
}

}  // namespace

template <int dim, int size>
Coarsening<dim, size>::Coarsening(const Grid<dim, size>& fine, double threshold)
    : aggregates_(strong_aggregates(fine.A, fine.part, threshold)) {
  find_patterns(fine.A.pattern);
}

template <int dim, int size>
void Coarsening<dim, size>::find_patterns(const BlockPattern& A) {
  BlockPattern own;
  for (int aggregate : aggregates_.of_node) {
    if (aggregate >= 0) own.column.push_back(aggregate);
    own.first.push_back(count_of(own.column));
  }
  P_.pattern = product(A, own, aggregate_count());
  P_.value.resize(P_.pattern.column.size());
  AP_ = product(A, P_.pattern, aggregate_count());
  transposed_P_ = transposed(P_.pattern, aggregate_count());
  tentative_.assign(node_count(), SingleBlock<size, coarse_size>::Zero());
}

/// Q_i - omega D^-1 (A Q)_i
template <int dim, int size>
void Coarsening<dim, size>::find_prolongation_row(const Fine& fine, int i,
                                                  NodeList& place) {
  const auto omega = static_cast<float>(4 / (3 * fine.largest()));
  const BlockRows<size, size>& A = fine.grid().A;
  const BlockPattern& row = P_.pattern;
  number_columns(row, i, row.begin(i), place);
  for (int k = row.begin(i); k < row.end(i); ++k) P_.value[k].setZero();
  for (int k = A.pattern.begin(i); k < A.pattern.end(i); ++k)
    if (const int j = A.pattern.column[k]; aggregates_.of_node[j] >= 0)
      P_.value[place[aggregates_.of_node[j]]] += A.value[k] * tentative_[j];
  for (int k = row.begin(i); k < row.end(i); ++k)
    P_.value[k] = -omega * (fine.inverse(i) * P_.value[k]).eval();
  if (aggregates_.of_node[i] >= 0)
    P_.value[place[aggregates_.of_node[i]]] += tentative_[i];
}

template <int dim, int size>
void Coarsening<dim, size>::find_prolongation(const Fine& fine,
                                              const NodeList& nodes) {
#pragma omp parallel
  {
    NodeList place(aggregate_count(), -1);
#pragma omp for
    for (int n = 0; n < count_of(nodes); ++n)
      find_prolongation_row(fine, nodes[n], place);
  }
}

/// (A P)_i, in the order of AP_.
template <int dim, int size>
void Coarsening<dim, size>::find_product_row(const FineMatrix& A, int i,
                                             NodeList& place,
                                             BlockOfP* row) const {
  number_columns(AP_, i, 0, place);
  std::fill(row, row + AP_.end(i) - AP_.begin(i), BlockOfP::Zero());
  for (int k = A.pattern.begin(i); k < A.pattern.end(i); ++k) {
    const int j = A.pattern.column[k];
    for (int l = P_.pattern.begin(j); l < P_.pattern.end(j); ++l)
      row[place[P_.pattern.column[l]]] += A.value[k] * P_.value[l];
  }
}

/// A_IJ = sum P_iI' (A P)_iJ, by rows.
template <int dim, int size>
void Coarsening<dim, size>::find_coarse_row(int I, NodeList& place,
                                            const ProductRows& products,
                                            CoarseMatrix& coarse) const {
  const BlockPattern &row = coarse.pattern, &R = transposed_P_.pattern;
  number_columns(row, I, row.begin(I), place);
  for (int k = row.begin(I); k < row.end(I); ++k) coarse.value[k].setZero();
  for (int k = R.begin(I); k < R.end(I); ++k) {
    const int i = R.column[k];
    const SingleBlock<coarse_size, size> R_Ii =
        P_.value[transposed_P_.place[k]].transpose();
    for (int l = AP_.begin(i); l < AP_.end(i); ++l)
      coarse.value[place[AP_.column[l]]].noalias() +=
          R_Ii * products.value[products.first[i] + l - AP_.begin(i)];
  }
}

/// With an entry in these rows of P'.
template <int dim, int size>
NodeList Coarsening<dim, size>::nodes_beside(const NodeList& aggregates) const {
  NodeList found;
  for (int I : aggregates) append_row(transposed_P_.pattern, I, found);
  return ascending(std::move(found));
}

template <int dim, int size>
void Coarsening<dim, size>::find_coarse_rows(const FineMatrix& A,
                                             const NodeList& aggregates,
                                             ProductRows& products,
                                             CoarseMatrix& coarse) const {
  const NodeList needed = nodes_beside(aggregates);
  int blocks = 0;
  for (int i : needed) {
    products.first[i] = blocks;
    blocks += AP_.end(i) - AP_.begin(i);
  }
  if (blocks > count_of(products.value)) products.value.resize(blocks);
#pragma omp parallel
  {
    NodeList place(aggregate_count(), -1);
#pragma omp for
    for (int n = 0; n < count_of(needed); ++n)
      find_product_row(A, needed[n], place,
                       &products.value[products.first[needed[n]]]);
#pragma omp for
    for (int n = 0; n < count_of(aggregates); ++n)
      find_coarse_row(aggregates[n], place, products, coarse);
  }
}

template <int dim, int size>
auto Coarsening<dim, size>::coarse_grid(const Fine& fine) -> CoarseGrid {
  CoarseGrid coarse;
  coarse.A.pattern = product(transposed_P_.pattern, AP_, aggregate_count());
  coarse.A.value.resize(coarse.A.pattern.column.size());
  coarse.motions.resize(aggregate_count());
  for (const NodeList& members : aggregates_.members)
    coarse.part.push_back(fine.grid().part[members.front()]);
  const NodeList all = all_below(node_count());
  follow(fine, {all, all}, coarse);
  return coarse;
}

/// With an entry in one of the nodes' rows of P.
template <int dim, int size>
NodeList Coarsening<dim, size>::aggregates_beside(const NodeList& nodes) const {
  if (count_of(nodes) == node_count()) return all_below(aggregate_count());
  NodeList found;
  for (int i : nodes) append_row(P_.pattern, i, found);
  return ascending(std::move(found));
}

/// @return nodes whose Q is new
template <int dim, int size>
NodeList Coarsening<dim, size>::find_bases(const Grid<dim, size>& fine,
                                           const NodeList& aggregates,
                                           CoarseGrid& coarse) {
#pragma omp parallel for
  for (int k = 0; k < count_of(aggregates); ++k) {
    const NodeList& members = aggregates_.members[aggregates[k]];
    const auto basis = aggregate_basis(fine.motions, members);
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
NodeList Coarsening<dim, size>::aggregates_of(const NodeList& nodes) const {
  NodeList found;
  for (int i : nodes)
    if (aggregates_.of_node[i] >= 0) found.push_back(aggregates_.of_node[i]);
  return ascending(std::move(found));
}

template <int dim, int size>
ChangedNodes Coarsening<dim, size>::follow(const Fine& fine,
                                           const ChangedNodes& changed,
                                           CoarseGrid& coarse) {
  const BlockPattern& A = fine.grid().A.pattern;
  ChangedNodes result;
  result.motions = aggregates_of(changed.motions);
  NodeList moved =
      with_neighbours(A, find_bases(fine.grid(), result.motions, coarse));
  moved.insert(moved.end(), changed.rows.begin(), changed.rows.end());
  moved = ascending(std::move(moved));
  find_prolongation(fine, moved);
  result.rows = aggregates_beside(with_neighbours(A, moved));
  // a few at a time: A P has as many numbers as A
  constexpr int at_once = 512;
  ProductRows products{NodeList(node_count()), {}};
  const auto end = result.rows.end();
  for (auto next = result.rows.begin(); next != end;) {
    const auto begin = std::exchange(
        next, next + std::min<std::ptrdiff_t>(at_once, end - next));
    find_coarse_rows(fine.grid().A, NodeList(begin, next), products, coarse.A);
  }
  return result;
}

template <int dim, int size>
VectorXf Coarsening<dim, size>::restricted(const VectorXf& residual) const {
  constexpr int ahead = 16;
  const BlockPattern& R = transposed_P_.pattern;
  VectorXf result =
      VectorXf::Zero(static_cast<Index>(coarse_size) * aggregate_count());
#pragma omp parallel for
  for (int I = 0; I < aggregate_count(); ++I) {
    auto sum = block_of<coarse_size>(result, I);
    for (int k = R.begin(I); k < R.end(I); ++k) {
      // these come from all over P
      if (k + ahead < R.end(I))
        __builtin_prefetch(&P_.value[transposed_P_.place[k + ahead]]);
      sum += P_.value[transposed_P_.place[k]].transpose() *
             block_of<size>(residual, R.column[k]);
    }
  }
  return result;
}

template class Coarsening<3, 3>;
template class Coarsening<3, 6>;

}  // namespace ffcontact
