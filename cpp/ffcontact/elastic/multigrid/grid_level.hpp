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

/// Nodes of a grid whose rows, or whose motions, are not what they were.
struct ChangedNodes {
  NodeList rows, motions;
};

/// One grid of smoothed aggregation, its smoother, and what makes the next coarser one of it.
template <int dim, int size>
class GridLevel {
 public:
  static constexpr int coarse_size = NodeMotions<dim, size>::count;
  using CoarseGrid = Grid<dim, coarse_size>;

  /// @param threshold  of strong_aggregates
  GridLevel(Grid<dim, size> grid, double threshold);

  int node_count() const { return grid_.A.rows(); }
  int aggregate_count() const { return aggregates_.count(); }
  const BlockRows<size, size>& matrix() const { return grid_.A; }
  /// To be changed; refresh is told where.
  Grid<dim, size>& grid() { return grid_; }

  /// The coarser grid of this one.
  CoarseGrid coarse_grid();
  /// The same where it changes.
  /// @return the aggregates
  ChangedNodes refresh(const ChangedNodes& changed, CoarseGrid& coarse);

  /// Chebyshev's polynomial of degree 2 of D^-1 A, D the blocks on the diagonal, for the
  /// upper nine tenths of the spectrum: a change of x for the residual, which becomes
  /// that of x + change.
  VectorXf smoothed(VectorXf& residual) const;
  VectorXf residual(const VectorXf& right, const VectorXf& x) const;
  VectorXf restricted(const VectorXf& residual) const {
    return product(R_, residual);
  }
  VectorXf prolonged(const VectorXf& coarse) const {
    return product(P_, coarse);
  }

 private:
  using BlockOfP = SingleBlock<size, coarse_size>;
  using CoarseMatrix = BlockRows<coarse_size, coarse_size>;

  void find_inverses(const NodeList& nodes);
  double largest_eigenvalue() const;
  void find_patterns();
  /// refresh with the inverses at hand.
  ChangedNodes follow(const ChangedNodes& changed, CoarseGrid& coarse);
  NodeList find_bases(const NodeList& aggregates, CoarseGrid& coarse);
  void find_prolongation(const NodeList& nodes);
  void find_prolongation_row(int i, NodeList& place);
  void find_product_row(int i, NodeList& place, BlockOfP* row) const;
  void find_coarse_row(int I, NodeList& place,
                       const std::vector<BlockOfP>& products,
                       const NodeList& first, CoarseMatrix& coarse) const;
  void find_coarse_rows(const NodeList& needed, const NodeList& aggregates,
                        CoarseMatrix& coarse) const;
  NodeList with_neighbours(const NodeList& nodes) const;
  NodeList aggregates_of(const NodeList& nodes) const;
  NodeList aggregates_beside(const NodeList& nodes) const;

  Grid<dim, size> grid_;
  std::vector<SingleBlock<size, size>> inverse_;  ///< D^-1
  double largest_ = 0;  ///< above the largest eigenvalue of D^-1 A
  StrongAggregates aggregates_;
  std::vector<BlockOfP> tentative_;  ///< Q of each node
  BlockRows<size, coarse_size> P_;
  BlockRows<coarse_size, size> R_;  ///< P', row by row
  NodeList place_in_R_;             ///< of each block of P
  BlockPattern AP_;
};

}  // namespace ffcontact
