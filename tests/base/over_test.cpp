// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/over.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

TEST(Over, numbers_goes_up_to_the_last_but_one) {
  const auto half = [](int k) { return 0.5 * k; };
  EXPECT_EQ(sum_over(4, half), 3);
  EXPECT_EQ(largest_over(4, half), 1.5);
  EXPECT_EQ(largest_over(3, [](int k) { return -1.0 - k; }), 0);
  EXPECT_EQ(numbers_where(5, [](int k) { return k % 2 == 1; }),
            (std::vector<int>{1, 3}));
}

}  // namespace
}  // namespace ffcontact
