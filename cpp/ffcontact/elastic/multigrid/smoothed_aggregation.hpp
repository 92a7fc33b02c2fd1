// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "ffcontact/elastic/multigrid/coarsening.hpp"
#include "ffcontact/elastic/multigrid/dropping_cholesky.hpp"

namespace ffcontact {

/// Multigrid of an elastic body by smoothed aggregation [Vanek, Mandel, Brezina 1996]: a
/// symmetric positive semidefinite M near A^-1, for conjugate gradients and GMRES, whose
/// cost is some ten products with A. On each grid nodes are gathered with their strong
/// neighbours in aggregates, which move as rigid bodies, by
///     P = (1 - 4 / (3 lambda) D^-1 A) Q,   A_coarse = P' A P,
/// with the blocks D on A's diagonal and lambda above the largest eigenvalue of D^-1 A. In
/// single precision: M does not have to be exact. Singular A, of bodies that nothing
/// holds, are no exception: the pivots of their rigid motions on the coarsest grid are
/// dropped.
///
/// A change of A at a few nodes, as of contact that opens or slips, is followed by what
/// depends on it, on all grids; aggregates and lambda stay.
template <int dim>
class SmoothedAggregation {
 public:
  static constexpr int coarse_size = Coarsening<dim, dim>::coarse_size;

  /// @param grid  A of the vertices, with motions of radius 0
  explicit SmoothedAggregation(Grid<dim, dim> grid);

  const BlockRows<dim, dim>& matrix() const { return finest_.fine.grid().A; }
  /// M right
  VectorXf operator()(const VectorXf& right) const;

  /// What a vertex is to have in place of its block on the diagonal and its motions.
  struct Change {
    int vertex;
    SingleBlock<dim, dim> diagonal;
    SingleBlock<dim, coarse_size> motions;
  };
  void put(const std::vector<Change>& changes);

 private:
  template <int size>
  struct Level {
    Level(Grid<dim, size> grid, double threshold)
        : fine(std::move(grid)), coarsening(fine.grid(), threshold) {}

    SmoothedGrid<dim, size> fine;
    Coarsening<dim, size> coarsening;
  };

  VectorXf cycle(std::size_t level, const VectorXf& right) const;
  template <int size>
  VectorXf cycle(const Level<size>& level, std::size_t next,
                 const VectorXf& right) const;

  Level<dim> finest_;
  std::vector<Level<coarse_size>> coarse_;
  /// the grid beyond the last one, solved by its factor
  Grid<dim, coarse_size> last_;
  DroppingCholesky factor_;
};

}  // namespace ffcontact
