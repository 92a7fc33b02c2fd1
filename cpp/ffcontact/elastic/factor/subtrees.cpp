// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/subtrees.hpp"

#include <numeric>
#include <queue>
#include <utility>

namespace ffcontact {

namespace {

/// The supernode of each eliminated column.
std::vector<int> supernode_of_columns(const Supernodes& nodes) {
  std::vector<int> supernode(nodes.first_column.back());
  for (int s = 0; s < nodes.count(); ++s)
    for (int j = nodes.first_column[s]; j < nodes.first_column[s + 1]; ++j)
      supernode[j] = s;
  return supernode;
}

/// The supernode of the first row below each one's diagonal block, or -1.
std::vector<int> parents(const Supernodes& nodes) {
  const std::vector<int> supernode = supernode_of_columns(nodes);
  std::vector<int> parent(nodes.count(), -1);
  for (int s = 0; s < nodes.count(); ++s) {
    const int* next = nodes.rows_below(s);
    if (next != nodes.end_of_rows(s) && *next < nodes.first_column.back())
      parent[s] = supernode[*next];
  }
  return parent;
}

/// Of every supernode and all below it.
std::vector<double> works(const Supernodes& nodes,
                          const std::vector<int>& parent) {
  std::vector<double> work(nodes.count(), 0);
  for (int s = 0; s < nodes.count(); ++s) {
    work[s] += work_of(nodes, s);
    if (parent[s] >= 0) work[parent[s]] += work[s];
  }
  return work;
}

std::vector<std::vector<int>> children(const std::vector<int>& parent) {
  std::vector<std::vector<int>> result(parent.size());
  for (std::size_t s = 0; s < parent.size(); ++s)
    if (parent[s] >= 0) result[parent[s]].push_back(static_cast<int>(s));
  return result;
}

constexpr int no_subtree = -1;

/// Supernodes whose work with all below them is at most this share of the whole, and whose
/// parents' is more.
std::vector<int> subtree_roots(const std::vector<int>& parent,
                               const std::vector<double>& work, double share) {
  const std::vector<std::vector<int>> below = children(parent);
  std::priority_queue<std::pair<double, int>> roots;
  double all = 0;
  for (std::size_t s = 0; s < parent.size(); ++s)
    if (parent[s] < 0) {
      roots.emplace(work[s], static_cast<int>(s));
      all += work[s];
    }
  while (!roots.empty() && roots.top().first > share * all) {
    const int split = roots.top().second;
    roots.pop();
    for (int s : below[split]) roots.emplace(work[s], s);
  }
  std::vector<int> result;
  for (; !roots.empty(); roots.pop()) result.push_back(roots.top().second);
  return result;
}

/// The number of the root that each supernode is at or below, or no_subtree.
std::vector<int> subtree_of_supernodes(const std::vector<int>& parent,
                                       const std::vector<int>& roots) {
  std::vector<int> subtree(parent.size(), no_subtree);
  for (std::size_t k = 0; k < roots.size(); ++k)
    subtree[roots[k]] = static_cast<int>(k);
  for (std::size_t s = parent.size(); s-- > 0;)
    if (parent[s] >= 0 && subtree[s] == no_subtree)
      subtree[s] = subtree[parent[s]];
  return subtree;
}

}  // namespace

double work_of(const Supernodes& nodes, int s) {
  const double rows = nodes.row_count(s);
  return nodes.column_count(s) * rows * rows;
}

Subtrees subtrees(const Supernodes& nodes, double share) {
  const std::vector<int> parent = parents(nodes);
  const std::vector<int> roots =
      subtree_roots(parent, works(nodes, parent), share);
  const std::vector<int> subtree = subtree_of_supernodes(parent, roots);
  Subtrees result;
  result.supernodes.resize(roots.size());
  for (int s = 0; s < nodes.count(); ++s)
    if (subtree[s] == no_subtree)
      result.above.push_back(s);
    else
      result.supernodes[subtree[s]].push_back(s);
  return result;
}

}  // namespace ffcontact
