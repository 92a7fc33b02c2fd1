// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/facing_groups.hpp"

#include <algorithm>

#include "ffcontact/base/unions.hpp"

namespace ffcontact {

std::vector<std::vector<int>> facing_groups(const ContactLine& line) {
  const std::vector<int> vertices = contact_vertices(line);
  Unions joined(1 + *std::max_element(vertices.begin(), vertices.end()));
  for (int i = 0; i < line.node_count(); ++i)
    visit_opposite(line, i, [&](int vertex, double) {
      joined.join(line.vertex[i], vertex);
    });
  std::vector<std::vector<int>> groups;
  for (const auto& [root, set] : joined.sets_of(vertices))
    groups.emplace_back(set.begin(), set.end());
  return groups;
}

}  // namespace ffcontact
