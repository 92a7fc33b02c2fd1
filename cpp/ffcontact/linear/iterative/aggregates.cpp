// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/iterative/aggregates.hpp"

namespace ffcontact {

Aggregates aggregates(const SparseMatrix& neighbours) {
  const auto nodes = static_cast<int>(neighbours.cols());
  Aggregates result{std::vector<int>(nodes, -1), {}};
  std::vector<int>& of = result.of_node;
  const auto found = [&](int i) {
    of[i] = result.count();
    result.first.push_back(i);
  };
  const auto taken_beside = [&](int i) {
    for (SparseMatrix::InnerIterator e(neighbours, i); e; ++e)
      if (of[e.row()] >= 0) return of[e.row()];
    return -1;
  };
  for (int i = 0; i < nodes; ++i) {
    if (of[i] >= 0 || taken_beside(i) >= 0) continue;
    found(i);
    for (SparseMatrix::InnerIterator e(neighbours, i); e; ++e)
      of[e.row()] = of[i];
  }
  for (int i = 0; i < nodes; ++i) {
    if (of[i] >= 0) continue;
    if (const int beside = taken_beside(i); beside >= 0)
      of[i] = beside;
    else
      found(i);
  }
  return result;
}

}  // namespace ffcontact
