// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/free_tractions.hpp"

#include <gtest/gtest.h>

#include "support/problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(ContactEdgeNumbers, are_the_inverse_of_the_lines_edges) {
  const Problem problem =
      body(rectangle(3, 2, 3, 2), material(1, 0), {left, bottom});
  const std::vector<int> number =
      contact_edge_numbers(problem.line, problem.edges);
  for (int e = 0; e < problem.line.edge_count(); ++e)
    EXPECT_EQ(number[problem.line.edge[e]], e);
  EXPECT_EQ(
      std::count_if(number.begin(), number.end(), [](int n) { return n >= 0; }),
      5);
}

}  // namespace
}  // namespace ffcontact
