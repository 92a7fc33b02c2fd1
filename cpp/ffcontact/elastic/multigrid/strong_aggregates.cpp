// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/strong_aggregates.hpp"

#include <cmath>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/iterative/aggregates.hpp"

namespace ffcontact {

namespace {

/// Nodes that something is left of, and where each stands among them.
struct FreeNodes {
  NodeList node, place;
};
FreeNodes free_nodes(const VectorXd& norm) {
  FreeNodes found{{}, NodeList(norm.size(), -1)};
  for (int i = 0; i < norm.size(); ++i) {
    if (norm[i] == 0) continue;
    found.place[i] = count_of(found.node);
    found.node.push_back(i);
  }
  return found;
}

/// Which free nodes are strong neighbours.
template <int size>
SparseMatrix strong_neighbours(const BlockRows<size, size>& A,
                               const NodeList& part, const VectorXd& norm,
                               const FreeNodes& free, double threshold) {
  const Index count = count_of(free.node);
  SparseMatrix strong(count, count);
  for (Index column = 0; column < count; ++column) {
    strong.startVec(column);
    const int i = free.node[column];
    for (int k = A.pattern.begin(i); k < A.pattern.end(i); ++k) {
      const int j = A.pattern.column[k];
      const double own = A.value[k].template cast<double>().norm();
      if (free.place[j] >= 0 && part[i] == part[j] &&
          own > threshold * std::sqrt(norm[i] * norm[j]))
        strong.insertBack(free.place[j], column) = 1;
    }
  }
  strong.finalize();
  return strong;
}

}  // namespace

template <int size>
StrongAggregates strong_aggregates(const BlockRows<size, size>& A,
                                   const NodeList& part, double threshold) {
  VectorXd norm(A.rows());
  for (int i = 0; i < A.rows(); ++i)
    norm[i] = A.block(i, i).template cast<double>().norm();
  const FreeNodes free = free_nodes(norm);
  const Aggregates found =
      aggregates(strong_neighbours(A, part, norm, free, threshold));
  StrongAggregates result{NodeList(A.rows(), -1),
                          std::vector<NodeList>(found.count())};
  for (int k = 0; k < count_of(free.node); ++k) {
    result.of_node[free.node[k]] = found.of_node[k];
    result.members[found.of_node[k]].push_back(free.node[k]);
  }
  return result;
}

template StrongAggregates strong_aggregates(const BlockRows<3, 3>&,
                                            const NodeList&, double);
template StrongAggregates strong_aggregates(const BlockRows<6, 6>&,
                                            const NodeList&, double);

}  // namespace ffcontact
