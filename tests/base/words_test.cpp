// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/words.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

TEST(Words, have_few_digits_of_figures_and_ten_of_what_a_refusal_names) {
  EXPECT_EQ(in_digits(1.0 / 3), "0.3333");
  EXPECT_EQ(in_digits(1.0 / 3, 2), "0.33");
  EXPECT_EQ(in_words(Vector2d(0.1, -2.0 / 3)), "(0.1, -0.6666666667)");
  EXPECT_EQ(in_words(Vector3d(1, 0, 1e-20), digits_of_figures),
            "(1, 0, 1e-20)");
}

TEST(Words, are_numbers_where_they_are_digits_that_an_int_can_hold) {
  EXPECT_EQ(whole_number("12"), 12);
  EXPECT_EQ(whole_number("-3"), -3);
  for (const char* other : {"", "x", "1x", "1.5", " 1", "99999999999"})
    EXPECT_EQ(whole_number(other), std::nullopt) << other;
}

TEST(Words, of_a_list_end_with_the_given_one) {
  EXPECT_EQ(listed({"3"}, " and "), "3");
  EXPECT_EQ(listed({"3", "7"}, " and "), "3 and 7");
  EXPECT_EQ(listed({"3", "7", "9"}, " or "), "3, 7 or 9");
}

}  // namespace
}  // namespace ffcontact
