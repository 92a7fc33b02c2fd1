// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/plane.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

TEST(Cross, is_positive_counter_clockwise) {
  EXPECT_EQ(cross({2, 0}, {1, 3}), 6);
  EXPECT_EQ(cross({1, 3}, {2, 0}), -6);
}

TEST(Between, is_linear_with_the_given_ends) {
  EXPECT_EQ(between(3, 7, 0), 3);
  EXPECT_EQ(between(3, 7, 0.25), 4);
  EXPECT_EQ(between(Vector2d(0, 4), Vector2d(2, 0), 0.5), Vector2d(1, 2));
}

TEST(FiniteRoot, is_that_which_stays_finite) {
  // 1 - 3 s + 2 s^2 = (1 - s) (1 - 2 s)
  EXPECT_NEAR(*finite_root(1, -3, 2), 0.5, 1e-15);
  EXPECT_NEAR(*finite_root(-1, 3, -2), 0.5, 1e-15);
  EXPECT_NEAR(*finite_root(1, -2, 1e-18), 0.5, 1e-15);
  EXPECT_NEAR(*finite_root(1, 2, 0), -0.5, 1e-15);
}

TEST(FiniteRoot, is_none_where_roots_are_complex) {
  EXPECT_FALSE(finite_root(1, 0, 1).has_value());
}

}  // namespace
}  // namespace ffcontact
