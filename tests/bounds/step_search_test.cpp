// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/step_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ffcontact {
namespace {

/// Width after so many steps of a search that begins at 1.
template <class Width>
double width_after(int steps, double longest, const Width& width) {
  StepSearch search(longest);
  double least = INFINITY, s = 1;
  for (int k = 0; k < steps && s > 0; ++k) {
    least = std::min(least, width(s));
    search.add(s, width(s));
    s = search.next();
  }
  return least;
}

TEST(StepSearch, finds_the_least_width_on_either_side) {
  for (const double best : {0.3, 0.7, 3.7}) {
    const auto width = [best](double s) { return best / s + s / best; };
    EXPECT_LT(width_after(6, 100, width), 1.02 * 2);
  }
}

/// Beyond a step that changes what is in contact the width grows fast.
TEST(StepSearch, follows_the_branch_before_a_kink) {
  const auto width = [](double s) {
    return 1 / s + s / 2 + (s < 1.5 ? 0 : 4 * (s - 1.5));
  };
  EXPECT_LT(width_after(4, 100, width), 1.001 * std::sqrt(2));
}

TEST(StepSearch, goes_no_farther_than_the_longest_step) {
  StepSearch search(1.5);
  search.add(1, 1);
  search.add(0.5, 2);
  EXPECT_EQ(search.next(), 1.5);
  search.add(1.5, 0.5);
  EXPECT_EQ(search.next(), 0);
}

TEST(StepSearch, ends_where_nothing_is_to_be_gained) {
  StepSearch search(100);
  search.add(1, 0);
  EXPECT_EQ(search.next(), 0);
  search = StepSearch(100);
  const auto add = [&](double s) { search.add(s, 1 / s + s); };
  add(1);
  add(0.5);
  add(2);
  EXPECT_EQ(search.next(), 0);
}

}  // namespace
}  // namespace ffcontact
