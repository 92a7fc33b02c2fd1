// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"

#include <gtest/gtest.h>

#include <limits>

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
