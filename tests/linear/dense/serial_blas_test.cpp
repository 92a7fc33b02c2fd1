// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/serial_blas.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "support/threads.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(SerialBlas, gives_the_threads_back_when_the_last_one_goes) {
  const Threads two(2);
  std::optional<SerialBlas> one(std::in_place), other(std::in_place);
  EXPECT_EQ(openblas_get_num_threads(), 1);
  one.reset();
  EXPECT_EQ(openblas_get_num_threads(), 1);
  other.reset();
  EXPECT_EQ(openblas_get_num_threads(), 2);
}

}  // namespace
}  // namespace ffcontact
