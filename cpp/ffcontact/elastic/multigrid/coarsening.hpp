// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/multigrid/smoothed_grid.hpp"

namespace ffcontact {

/// Nodes of a grid whose rows, or whose motions, are not what they were.
struct ChangedNodes {
  NodeList rows, motions;
};

/// What makes the next coarser grid of one: aggregates, and P that prolongs their motions
/// (SmoothedAggregation). Where the grid changes what depends on it follows; aggregates and
/// patterns stay.
template <int dim, int size>
class Coarsening {
 public:
  static constexpr int coarse_size = NodeMotions<dim, size>::count;
  using Fine = SmoothedGrid<dim, size>;
  using CoarseGrid = Grid<dim, coarse_size>;

  /// @param threshold  of strong_aggregates
  Coarsening(const Grid<dim, size>& fine, double threshold);

  CoarseGrid coarse_grid(const Fine& fine);
  /// The same where the grid has changed.
  /// @return the aggregates
  ChangedNodes follow(const Fine& fine, const ChangedNodes& changed,
                      CoarseGrid& coarse);

  /// P' residual
  VectorXf restricted(const VectorXf& residual) const;
  VectorXf prolonged(const VectorXf& coarse) const {
    return product(P_, coarse);
  }

 private:
  using BlockOfP = SingleBlock<size, coarse_size>;
  using FineMatrix = BlockRows<size, size>;
  using CoarseMatrix = BlockRows<coarse_size, coarse_size>;
  /// Some rows of A P, and where they begin.
  struct ProductRows {
    NodeList first;
    std::vector<BlockOfP> value;
  };

  int node_count() const { return P_.rows(); }
  int aggregate_count() const { return aggregates_.count(); }
  void find_patterns(const BlockPattern& A);
  NodeList find_bases(const Grid<dim, size>& fine, const NodeList& aggregates,
                      CoarseGrid& coarse);
  void find_prolongation(const Fine& fine, const NodeList& nodes);
  void find_prolongation_row(const Fine& fine, int i, NodeList& place);
  void find_product_row(const FineMatrix& A, int i, NodeList& place,
                        BlockOfP* row) const;
  void find_coarse_row(int I, NodeList& place, const ProductRows& products,
                       CoarseMatrix& coarse) const;
  void find_coarse_rows(const FineMatrix& A, const NodeList& aggregates,
                        ProductRows& products, CoarseMatrix& coarse) const;
  NodeList aggregates_of(const NodeList& nodes) const;
  NodeList aggregates_beside(const NodeList& nodes) const;
  NodeList nodes_beside(const NodeList& aggregates) const;

  StrongAggregates aggregates_;
  std::vector<BlockOfP> tentative_;  ///< Q of each node
  BlockRows<size, coarse_size> P_;
  TransposedPattern transposed_P_;
  BlockPattern AP_;
};

}  // namespace ffcontact
