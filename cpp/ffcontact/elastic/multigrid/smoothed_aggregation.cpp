// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/smoothed_aggregation.hpp"

#include <utility>

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// Of a strong neighbour, on the finest grid; half of it on the next one, and so on.
/// Without one grids get coarse too fast, with a larger one too slowly.
constexpr double strong = 0.05;
/// Aggregates that are few enough for a factor, and grids that hardly get coarser.
constexpr int few = 100;
constexpr double hardly = 0.7;
constexpr std::size_t most_levels = 20;

/// All of it [size n x size n].
template <int size>
MatrixXd dense(const BlockRows<size, size>& A) {
  MatrixXd result = MatrixXd::Zero(size * A.rows(), size * A.rows());
  for (int i = 0; i < A.rows(); ++i)
    for (int k = A.pattern.begin(i); k < A.pattern.end(i); ++k)
      result.template block<size, size>(size * i, size * A.pattern.column[k]) =
          A.value[k].template cast<double>();
  return result;
}

}  // namespace

template <int dim>
SmoothedAggregation<dim>::SmoothedAggregation(Grid<dim, dim> grid)
    : finest_(std::move(grid), strong) {
  last_ = finest_.coarsening.coarse_grid(finest_.fine);
  double threshold = strong;
  int nodes = finest_.fine.node_count();
  while (last_.A.rows() > few && last_.A.rows() < hardly * nodes &&
         coarse_.size() < most_levels) {
    threshold /= 2;
    nodes = last_.A.rows();
    auto& level = coarse_.emplace_back(std::move(last_), threshold);
    last_ = level.coarsening.coarse_grid(level.fine);
  }
  factor_ = DroppingCholesky(dense(last_.A));
}

template <int dim>
void SmoothedAggregation<dim>::put(const std::vector<Change>& changes) {
  if (changes.empty()) return;
  ChangedNodes changed;
  for (const Change& change : changes) {
    Grid<dim, dim>& grid = finest_.fine.grid();
    grid.A.block(change.vertex, change.vertex) = change.diagonal;
    grid.motions[change.vertex].motions = change.motions;
    changed.rows.push_back(change.vertex);
  }
  changed.motions = changed.rows;
  const auto followed = [&](auto& level, std::size_t next) {
    level.fine.refresh(changed.rows);
    return level.coarsening.follow(
        level.fine, changed,
        next < coarse_.size() ? coarse_[next].fine.grid() : last_);
  };
  changed = followed(finest_, 0);
  for (std::size_t k = 0; k < coarse_.size(); ++k)
    changed = followed(coarse_[k], k + 1);
  factor_ = DroppingCholesky(dense(last_.A));
}

template <int dim>
template <int size>
VectorXf SmoothedAggregation<dim>::cycle(const Level<size>& level,
                                         std::size_t next,
                                         const VectorXf& right) const {
  const auto& [fine, coarsening] = level;
  VectorXf residual = right, x = fine.smoothed(residual);
  x += coarsening.prolonged(cycle(next, coarsening.restricted(residual)));
  residual = fine.residual(right, x);
  x += fine.smoothed(residual);
  return x;
}

template <int dim>
VectorXf SmoothedAggregation<dim>::cycle(std::size_t level,
                                         const VectorXf& right) const {
  if (level == coarse_.size()) return factor_.solve(right);
  return cycle(coarse_[level], level + 1, right);
}

template <int dim>
VectorXf SmoothedAggregation<dim>::operator()(const VectorXf& right) const {
  return cycle(finest_, 0, right);
}

template class SmoothedAggregation<3>;

}  // namespace ffcontact
