// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/unions.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

/// {0, 3, 4}, {1}, {2, 5}
Unions joined() {
  Unions unions(6);
  unions.join(4, 3);
  unions.join(5, 2);
  unions.join(3, 0);
  return unions;
}

TEST(Unions, number_their_sets_in_the_order_of_their_lowest_members) {
  EXPECT_EQ(joined().numbers(), (std::vector<int>{0, 1, 2, 0, 0, 2}));
}

TEST(Unions, have_the_sets_of_some_members_by_their_roots) {
  const std::map<int, std::set<int>> expected{{0, {3, 4}}, {2, {5}}};
  EXPECT_EQ(joined().sets_of({4, 5, 3, 4}), expected);
}

}  // namespace
}  // namespace ffcontact
