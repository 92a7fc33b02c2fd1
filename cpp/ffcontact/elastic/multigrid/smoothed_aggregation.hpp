// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/multigrid/dropping_cholesky.hpp"
#include "ffcontact/elastic/multigrid/grid_level.hpp"

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
  using Finest = GridLevel<dim, dim>;
  using Coarse = GridLevel<dim, Finest::coarse_size>;

  /// @param grid  A of the vertices, with motions of radius 0
  explicit SmoothedAggregation(Grid<dim, dim> grid);

  const BlockRows<dim, dim>& matrix() const { return finest_.matrix(); }
  /// M right
  VectorXf operator()(const VectorXf& right) const;

  /// What a vertex is to have in place of its block on the diagonal and its motions.
  struct Change {
    int vertex;
    SingleBlock<dim, dim> diagonal;
    SingleBlock<dim, Finest::coarse_size> motions;
  };
  void put(const std::vector<Change>& changes);

 private:
  VectorXf cycle(std::size_t level, const VectorXf& right) const;
  template <class Level>
  VectorXf cycle(const Level& level, std::size_t next,
                 const VectorXf& right) const;

  Finest finest_;
  std::vector<Coarse> coarse_;
  /// the grid beyond the last one, solved by its factor
  typename Finest::CoarseGrid last_;
  DroppingCholesky factor_;
};

}  // namespace ffcontact
