// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/displacement/contact_groups.hpp"

#include <algorithm>
#include <map>

namespace ffcontact {

namespace {

/// Vertices in groups that grow together.
class JoinedVertices {
 public:
  std::vector<std::vector<int>> groups;

  /// Puts a vertex, and the group that it may be in, into the last group.
  void join_last(int vertex) {
    const std::size_t last = groups.size() - 1;
    const auto [place, is_new] = group_of_.emplace(vertex, last);
    if (is_new)
      groups[last].push_back(vertex);
    else if (place->second != last)
      move_to_last(place->second);
  }

 private:
  void move_to_last(std::size_t old) {
    for (int v : groups[old]) {
      group_of_[v] = groups.size() - 1;
      groups.back().push_back(v);
    }
    groups[old].clear();
  }

  std::map<int, std::size_t> group_of_;
};

}  // namespace

std::vector<std::vector<int>> contact_groups(const ContactLine& line) {
  JoinedVertices joined;
  std::vector<std::vector<int>>& groups = joined.groups;
  for (int i = 0; i < line.node_count(); ++i) {
    groups.emplace_back();
    joined.join_last(line.vertex[i]);
    visit_opposite(line, i,
                   [&](int vertex, double) { joined.join_last(vertex); });
  }
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                              [](const auto& group) { return group.empty(); }),
               groups.end());
  return groups;
}

}  // namespace ffcontact
