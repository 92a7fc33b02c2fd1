// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/iterative/aggregates.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/unions.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

SparseMatrix graph(int nodes, const std::vector<std::pair<int, int>>& pairs) {
  Triplets entries;
  for (const auto& [a, b] : pairs) {
    entries.emplace_back(a, b, 1);
    entries.emplace_back(b, a, 1);
  }
  return packed(nodes, nodes, entries);
}

/// Every node is in one, together with its first one by neighbours of that aggregate.
RC_GTEST_PROP(Aggregates, are_connected_and_take_all, (Random random)) {
  const int nodes = *rc::gen::inRange(1, 60), edges = *rc::gen::inRange(0, 120);
  const auto node = [&] { return static_cast<int>(random() % nodes); };
  std::vector<std::pair<int, int>> pairs;
  for (int k = 0; k < edges; ++k) pairs.emplace_back(node(), node());
  const Aggregates result = aggregates(graph(nodes, pairs));
  Unions inside(nodes);
  for (const auto& [a, b] : pairs)
    if (result.of_node[a] == result.of_node[b]) inside.join(a, b);
  for (int i = 0; i < nodes; ++i) {
    const int own = result.of_node[i];
    RC_ASSERT(own >= 0 && own < result.count());
    RC_ASSERT(inside.root(i) == inside.root(result.first[own]));
  }
}

TEST(Aggregates, take_nodes_with_all_their_neighbours) {
  std::vector<std::pair<int, int>> chain;
  for (int i = 0; i < 8; ++i) chain.emplace_back(i, i + 1);
  const Aggregates result = aggregates(graph(9, chain));
  EXPECT_EQ(result.first, (std::vector<int>{0, 3, 6}));
  EXPECT_EQ(result.of_node, (std::vector<int>{0, 0, 1, 1, 1, 2, 2, 2, 2}));
}

}  // namespace
}  // namespace ffcontact
