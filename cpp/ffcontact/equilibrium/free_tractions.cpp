// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/free_tractions.hpp"

namespace ffcontact {

std::vector<int> contact_edge_numbers(const ContactLine& line,
                                      const Edges& edges) {
  std::vector<int> numbers(edges.count(), -1);
  for (int e = 0; e < line.edge_count(); ++e) {
    numbers[line.edge[e]] = e;
    if (line.against_a_body() && line.opposite_edge[e] >= 0)
      numbers[line.opposite_edge[e]] = e;
  }
  return numbers;
}

}  // namespace ffcontact
