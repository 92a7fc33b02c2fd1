// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/smoothed_grid.hpp"

#include <Eigen/LU>
#include <cmath>
#include <cstdint>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

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

}  // namespace

template <int dim, int size>
SmoothedGrid<dim, size>::SmoothedGrid(Grid<dim, size> grid)
    : grid_(std::move(grid)), inverse_(grid_.A.rows()) {
#pragma omp parallel for
  for (int i = 0; i < node_count(); ++i)
    inverse_[i] = inverse_of(grid_.A.block(i, i));
  largest_ = largest_eigenvalue();
}

template <int dim, int size>
void SmoothedGrid<dim, size>::refresh(const NodeList& rows) {
#pragma omp parallel for
  for (int k = 0; k < count_of(rows); ++k)
    inverse_[rows[k]] = inverse_of(grid_.A.block(rows[k], rows[k]));
}

template <int dim, int size>
double SmoothedGrid<dim, size>::largest_eigenvalue() const {
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
VectorXf SmoothedGrid<dim, size>::smoothed(VectorXf& residual) const {
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
VectorXf SmoothedGrid<dim, size>::residual(const VectorXf& right,
                                           const VectorXf& x) const {
  VectorXf left(right.size());
#pragma omp parallel for
  for (int i = 0; i < node_count(); ++i)
    block_of<size>(left, i) =
        block_of<size>(right, i) - grid_.A.row_times(i, x);
  return left;
}

template class SmoothedGrid<3, 3>;
template class SmoothedGrid<3, 6>;

}  // namespace ffcontact
