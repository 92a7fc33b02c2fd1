// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/free_tractions.hpp"

#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"

namespace ffcontact {

std::vector<int> contact_edge_numbers(const ContactLine& line,
                                      const Edges& edges) {
  std::vector<int> numbers(edges.count(), -1);
  for (int e = 0; e < line.edge_count(); ++e) {
    numbers[line.edge[e]] = e;
    const int facing = facing_edge(line, e);
    if (facing >= 0) numbers[facing] = e;
  }
  return numbers;
}

}  // namespace ffcontact
