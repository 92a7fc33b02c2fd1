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
  EXPECT_LT(width_after(5, 100, width), 1.001 * std::sqrt(2));
}

TEST(StepSearch, comes_back_from_the_shortest_step) {
  StepSearch search(100);
  for (const double s : {1.0, 0.25}) search.add(s, 0.4 / s + s / 0.4);
  EXPECT_NEAR(search.next(), 0.4, 1e-12);
}

/// Of a mean displacement: the longest step is the best one so far, but not the best of all.
TEST(StepSearch, comes_back_from_the_longest_step) {
  StepSearch search(1);
  search.add(0.25, 40.8);
  search.add(0.0625, 157.8);
  search.add(1, 21.4);
  EXPECT_NEAR(search.next(), 0.85, 0.05);
}

/// Widths of a mean displacement, whose contact changes between the best step and the longer
/// one: A / s + B s is nearer to the latter, and is tried where the parabola promises nothing.
TEST(StepSearch, tries_the_model_that_stays_near_first) {
  StepSearch far(1000);
  far.add(33.4, 1.094e-3);
  far.add(16.7, 2.16e-3);
  far.add(267, 3.24e-3);
  EXPECT_NEAR(far.next(), 58, 3);
  StepSearch near(1000);
  near.add(278, 1.91e-4);
  near.add(69.5, 5.31e-4);
  near.add(556, 2.56e-4);
  EXPECT_NEAR(near.next(), 400, 5);
}

/// Widths of two solids whose meshes do not match, of whose error little is left at the steps
/// that were tried.
TEST(StepSearch, looks_far_below_where_the_error_is_no_part_of_the_width) {
  const auto next = [](double error) {
    StepSearch search(108, error);
    search.add(27.08, 7.22e-3);
    search.add(6.77, 4.5e-3);
    search.add(9, 4.39e-3);
    return search.next();
  };
  EXPECT_EQ(next(0), 0);
  EXPECT_NEAR(next(6.7e-4), 1.02, 0.01);
  EXPECT_EQ(next(5e-3), 0);
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
