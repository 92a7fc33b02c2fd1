// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/multigrid/block_rows.hpp"

namespace ffcontact {

using NodeList = std::vector<int>;

struct StrongAggregates {
  NodeList of_node;  ///< the aggregate of each node, or -1
  std::vector<NodeList> members;

  int count() const { return static_cast<int>(members.size()); }
};

/// Nodes with their strong neighbours of the same part, |A_ij| > threshold (|A_ii|
/// |A_jj|)^1/2 in Frobenius' norm; nodes that are held, A_ii = 0, belong to no aggregate.
/// @param part  of each node
template <int size>
StrongAggregates strong_aggregates(const BlockRows<size, size>& A,
                                   const NodeList& part, double threshold);

}  // namespace ffcontact
