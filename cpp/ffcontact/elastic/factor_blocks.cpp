// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ffcontact {

namespace {

/// A power of 2 by which numbers of any size become such as single precision has.
double scale_of(const VectorXd& x) {
  const double largest = x.size() == 0 ? 0 : x.cwiseAbs().maxCoeff();
  return largest > 0 && std::isfinite(largest)
             ? std::exp2(std::floor(std::log2(largest)))
             : 1;
}

}  // namespace

template <class Scalar>
FactorBlocks<Scalar>::FactorBlocks(Supernodes of_nodes)
    : nodes(std::move(of_nodes)) {
  start_.push_back(0);
  for (int s = 0; s < nodes.count(); ++s)
    start_.push_back(start_.back() +
                     static_cast<std::size_t>(nodes.row_count(s)) *
                         nodes.column_count(s));
  values_.reset(new Scalar[start_.back()]);
}

template <class Scalar>
double FactorBlocks<Scalar>::reciprocal_condition() const {
  double least = 1, largest = 1;
  for (int s = 0; s < nodes.count(); ++s) {
    const auto diagonal = block(s).diagonal();
    if (!diagonal.allFinite()) return 0;
    const double low = diagonal.minCoeff(), high = diagonal.maxCoeff();
    least = s == 0 ? low : std::min(least, low);
    largest = s == 0 ? high : std::max(largest, high);
  }
  const double ratio = std::max(least, 0.0) / largest;
  return ratio * ratio;
}

template <class Scalar>
VectorXd FactorBlocks<Scalar>::half_solve(const VectorXd& right) const {
  const double scale = scale_of(right);
  VectorXd b = right / scale;
  for (int s = 0; s < nodes.count(); ++s) {
    const auto L = block(s);
    const Index n = L.cols(), below = L.rows() - n;
    auto own = b.segment(nodes.first_column[s], n);
    Column x = own.template cast<Scalar>();
    L.topRows(n).template triangularView<Eigen::Lower>().solveInPlace(x);
    own = x.template cast<double>();
    const Column product = L.bottomRows(below) * x;
    const int* row = nodes.rows_below(s);
    for (Index i = 0; i < below; ++i) b[row[i]] -= product[i];
  }
  return scale * b;
}

template <class Scalar>
VectorXd FactorBlocks<Scalar>::other_half_solve(const VectorXd& right) const {
  const double scale = scale_of(right);
  Column y = (right / scale).template cast<Scalar>();
  for (int s = nodes.count() - 1; s >= 0; --s) {
    const auto L = block(s);
    const Index n = L.cols(), below = L.rows() - n;
    const Map<const VectorXi> rows(nodes.rows_below(s), below);
    auto x = y.segment(nodes.first_column[s], n);
    const Column known = y(rows);
    x.noalias() -= L.bottomRows(below).transpose() * known;
    L.topRows(n)
        .transpose()
        .template triangularView<Eigen::Upper>()
        .solveInPlace(x);
  }
  return scale * y.template cast<double>();
}

template struct FactorBlocks<double>;
template struct FactorBlocks<float>;

}  // namespace ffcontact
