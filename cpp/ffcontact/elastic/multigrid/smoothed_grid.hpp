// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/multigrid/block_rows.hpp"
#include "ffcontact/elastic/multigrid/node_motions.hpp"
#include "ffcontact/elastic/multigrid/strong_aggregates.hpp"

namespace ffcontact {

/// A symmetric positive semidefinite matrix of nodes with `size` unknowns, and how rigid
/// motions move these. An unknown is held where its entry on A's diagonal is 0: it stays
/// 0, and its row and column count for nothing, whatever else stands in them.
template <int dim, int size>
struct Grid {
  BlockRows<size, size> A;
  std::vector<NodeMotions<dim, size>> motions;  ///< of each node
  NodeList part;  ///< of each node: those of several parts make no aggregate
};

/// A grid and its smoother, by the blocks D on A's diagonal.
template <int dim, int size>
class SmoothedGrid {
 public:
  explicit SmoothedGrid(Grid<dim, size> grid);

  int node_count() const { return grid_.A.rows(); }
  const Grid<dim, size>& grid() const { return grid_; }
  /// To be changed; refresh is told where A is.
  Grid<dim, size>& grid() { return grid_; }
  void refresh(const NodeList& rows);

  /// D^-1 of a node.
  const SingleBlock<size, size>& inverse(int node) const {
    return inverse_[node];
  }
  /// Above the largest eigenvalue of D^-1 A.
  double largest() const { return largest_; }

  /// Chebyshev's polynomial of degree 2 of D^-1 A for the upper nine tenths of the
  /// spectrum: a change of x for the residual, which becomes that of x + change.
  VectorXf smoothed(VectorXf& residual) const;
  VectorXf residual(const VectorXf& right, const VectorXf& x) const;

 private:
  double largest_eigenvalue() const;

  Grid<dim, size> grid_;
  std::vector<SingleBlock<size, size>> inverse_;
  double largest_ = 0;
};

}  // namespace ffcontact
