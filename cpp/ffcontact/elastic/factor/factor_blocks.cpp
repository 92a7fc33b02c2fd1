// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/factor_blocks.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/over.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// A subtree is at most this share of the work: what is computed how does not depend on
/// the number of threads.
constexpr double subtree_share = 0.0625;
/// Products of an elimination from which on threads pay.
constexpr double least_shared_work = 1e8;
/// Of a product of a block.
constexpr Index rows_at_once = 1024;

double work_of(const Supernodes& nodes) {
  return sum_over(nodes.count(), [&](int s) { return work_of(nodes, s); });
}

/// A power of 2 by which numbers of any size become such as single precision has.
double scale_of(const VectorXd& x) {
  const double largest = max_norm(x);
  return largest > 0 && std::isfinite(largest)
             ? std::exp2(std::floor(std::log2(largest)))
             : 1;
}

/// Some rows of a block: one type for all that is done with them.
template <class Block>
auto rows_of(const Block& L, Index first, Index count) {
  using Rows = Map<const typename Block::PlainMatrix, 0, Eigen::OuterStride<>>;
  return Rows(L.data() + first, count, L.cols(),
              Eigen::OuterStride<>(L.rows()));
}

}  // namespace

template <class Scalar>
FactorBlocks<Scalar>::FactorBlocks(Supernodes of_nodes)
    : nodes(std::move(of_nodes)),
      tree(subtrees(nodes, subtree_share)),
      worth_threads_(work_of(nodes) >= least_shared_work),
      place_above_(nodes.first_column.back(), -1) {
  for (int s : tree.above)
    for (int j = nodes.first_column[s]; j < nodes.first_column[s + 1]; ++j) {
      place_above_[j] = static_cast<int>(above_.size());
      above_.push_back(j);
    }
  start_.push_back(0);
  for (int s = 0; s < nodes.count(); ++s)
    start_.push_back(start_.back() +
                     static_cast<std::size_t>(nodes.row_count(s)) *
                         nodes.column_count(s));
  values_.reset(new Scalar[start_.back()]);
}

template <class Scalar>
int FactorBlocks<Scalar>::thread_count() const {
  return worth_threads_ ? omp_get_max_threads() : 1;
}

template <class Scalar>
double FactorBlocks<Scalar>::reciprocal_condition() const {
  VectorXd pivots(nodes.first_column.back());
  for (int s = 0; s < nodes.count(); ++s) {
    const auto L = block(s);
    for (Index j = 0; j < L.cols(); ++j)
      pivots[nodes.first_column[s] + j] = L(j, j);
  }
  if (pivots.size() == 0) return 1;
  if (!pivots.allFinite()) return 0;
  const double ratio = std::max(pivots.minCoeff(), 0.0) / pivots.maxCoeff();
  return ratio * ratio;
}

template <class Scalar>
typename FactorBlocks<Scalar>::Column FactorBlocks<Scalar>::eliminate(
    int s, VectorXd& b) const {
  const auto L = block(s);
  const Index n = L.cols(), below = L.rows() - n;
  auto own = b.segment(nodes.first_column[s], n);
  Column x = own.template cast<Scalar>(), product(below);
  rows_of(L, 0, n).template triangularView<Eigen::Lower>().solveInPlace(x);
  own = x.template cast<double>();
#pragma omp parallel for if (below > rows_at_once)
  for (Index first = 0; first < below; first += rows_at_once) {
    const Index count = std::min(rows_at_once, below - first);
    product.segment(first, count).noalias() = rows_of(L, n + first, count) * x;
  }
  return product;
}

template <class Scalar>
void FactorBlocks<Scalar>::substitute(int s, Column& y) const {
  const auto L = block(s);
  const Index n = L.cols(), below = L.rows() - n,
              parts = (below + rows_at_once - 1) / rows_at_once;
  Column known(below);
  const int* row = nodes.rows_below(s);
  for (Scalar& value : known) value = y[*row++];
  Square products(n, parts);
#pragma omp parallel for if (parts > 1)
  for (Index part = 0; part < parts; ++part) {
    const Index first = part * rows_at_once,
                count = std::min(rows_at_once, below - first);
    products.col(part).noalias() =
        rows_of(L, n + first, count).transpose() * known.segment(first, count);
  }
  auto x = y.segment(nodes.first_column[s], n);
  for (Index part = 0; part < parts; ++part) x -= products.col(part);
  rows_of(L, 0, n)
      .transpose()
      .template triangularView<Eigen::Upper>()
      .solveInPlace(x);
}

template <class Scalar>
VectorXd FactorBlocks<Scalar>::half_solve(const VectorXd& right) const {
  const double scale = scale_of(right);
  VectorXd b = right / scale;
  const Index eliminated = nodes.first_column.back(), columns = above_.size(),
              kept = b.size() - eliminated;
  const auto subtrees = static_cast<Index>(tree.supernodes.size());
  MatrixXd on_others = MatrixXd::Zero(columns + kept, subtrees);
  const auto subtract = [&](int s, const Column& product, double* sum) {
    const int* row = nodes.rows_below(s);
    for (Index i = 0; i < product.size(); ++i, ++row)
      if (*row >= eliminated)
        sum[columns + *row - eliminated] -= product[i];
      else if (const int place = place_above_[*row]; place >= 0)
        sum[place] -= product[i];
      else
        b[*row] -= product[i];
  };
#pragma omp parallel for schedule(dynamic, 1) num_threads(thread_count())
  for (Index k = 0; k < subtrees; ++k)
    for (int s : tree.supernodes[k])
      subtract(s, eliminate(s, b), on_others.col(k).data());
  const VectorXd sum = on_others.rowwise().sum();
  for (Index i = 0; i < columns; ++i) b[above_[i]] += sum[i];
  b.tail(kept) += sum.tail(kept);
  for (int s : tree.above) {
    const Column product = eliminate(s, b);
    const int* row = nodes.rows_below(s);
    for (double p : product) b[*row++] -= p;
  }
  return scale * b;
}

template <class Scalar>
VectorXd FactorBlocks<Scalar>::other_half_solve(const VectorXd& right) const {
  const double scale = scale_of(right);
  Column y = (right / scale).template cast<Scalar>();
  for (auto s = tree.above.rbegin(); s != tree.above.rend(); ++s)
    substitute(*s, y);
  const auto subtrees = static_cast<Index>(tree.supernodes.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(thread_count())
  for (Index k = 0; k < subtrees; ++k) {
    const std::vector<int>& own = tree.supernodes[k];
    for (auto s = own.rbegin(); s != own.rend(); ++s) substitute(*s, y);
  }
  return scale * y.template cast<double>();
}

template struct FactorBlocks<double>;
template struct FactorBlocks<float>;

}  // namespace ffcontact
