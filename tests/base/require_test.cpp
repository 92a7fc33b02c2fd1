// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <new>

#include "ffcontact/base/entry_of.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Require, refuse_joins_its_parts_into_one_sentence) {
  EXPECT_EQ(refusal([] { refuse("friction[", 3, "] is ", -0.5); }),
            "friction[3] is -0.5");
}

TEST(Require, the_sentence_of_what_is_no_refusal_says_so) {
  EXPECT_EQ(sentence_of(Refusal("mu is -1")), "mu is -1");
  EXPECT_EQ(sentence_of(Failure("CHOLMOD failed")), "CHOLMOD failed");
  EXPECT_EQ(sentence_of(std::bad_alloc()), "out of memory");
  EXPECT_EQ(sentence_of(std::out_of_range("map::at")),
            "an internal error of ffcontact (map::at): please report it, with "
            "the script");
  EXPECT_EQ(sentence_of(std::invalid_argument("stoi")),
            "an internal error of ffcontact (stoi): please report it, with the "
            "script");
}

TEST(Require, an_entry_that_a_map_must_have_is_found_or_missed_by_name) {
  std::map<int, int> squares{{2, 4}};
  EXPECT_EQ(entry_of(squares, 2, "square"), 4);
  entry_of(squares, 2, "square") = 5;
  EXPECT_EQ(squares[2], 5);
  EXPECT_THROW(entry_of(squares, 3, "square"), std::logic_error);
}

TEST(Require, a_wrong_size_is_named_with_the_right_one) {
  EXPECT_EQ(refusal([] { require_size("gap", 3, 4); }),
            "gap has 3 values where 4 are needed");
  EXPECT_EQ(refusal([] { require_size("gap", 4, 4); }), "accepted");
}

TEST(Require, the_first_value_that_is_not_finite_is_named) {
  EXPECT_EQ(
      refusal([] { require_finite("b", Vector3d(1, infinite, -infinite)); }),
      "b[1] is inf, not a finite number");
  EXPECT_EQ(refusal([] { require_finite("b", Vector3d(1, 2, std::nan(""))); }),
            "b[2] is nan, not a finite number");
  EXPECT_EQ(refusal([] { require_finite("b", Vector3d(1, 2, -3)); }),
            "accepted");
}

TEST(Require, the_first_value_that_is_negative_or_not_finite_is_named) {
  const auto refusal_of = [](double a, double b) {
    return refusal([&] { require_nonnegative("friction", Vector2d(a, b)); });
  };
  EXPECT_EQ(refusal_of(0, -0.1),
            "friction must be finite and not negative, but value 1 is -0.1");
  EXPECT_EQ(refusal_of(infinite, 0),
            "friction must be finite and not negative, but value 0 is inf");
  EXPECT_EQ(refusal_of(std::nan(""), 0),
            "friction must be finite and not negative, but value 0 is nan");
  EXPECT_EQ(refusal_of(0, 1), "accepted");
}

}  // namespace
}  // namespace ffcontact
