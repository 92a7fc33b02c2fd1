// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/memory.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ffcontact {
namespace {

TEST(Memory, is_that_of_a_machine_and_what_is_left_of_it) {
  constexpr double megabyte = 1e6;
  EXPECT_GT(memory_of_the_machine(), 100 * megabyte);
  EXPECT_GT(available_memory(), megabyte);
  EXPECT_TRUE(std::isfinite(available_memory()));
}

}  // namespace
}  // namespace ffcontact
