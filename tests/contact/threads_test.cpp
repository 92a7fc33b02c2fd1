// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "support/problems.hpp"

extern "C" {
int openblas_get_num_threads() __attribute__((weak));
void openblas_set_num_threads(int) __attribute__((weak));
}

namespace ffcontact {
namespace {

using namespace test;

/// OpenBLAS splits its products by threads, so that the answers agree to rounding, not to
/// the bit; states agree exactly.
TEST(Threads, do_not_change_the_answer) {
  if (!openblas_set_num_threads) GTEST_SKIP() << "another BLAS";
  const int threads = openblas_get_num_threads();
  for (const Multiplier multiplier :
       {Multiplier::force, Multiplier::pressure}) {
    const Problem problem = example_1(multiplier, 64);
    openblas_set_num_threads(1);
    const ContactSolution one = solved(problem), again = solved(problem);
    openblas_set_num_threads(2);
    const ContactSolution two = solved(problem);
    EXPECT_EQ(again.displacement, one.displacement);
    EXPECT_EQ(two.state, one.state);
    EXPECT_LT(relative_difference(two.displacement, one.displacement), 1e-12);
    EXPECT_LT(relative_difference(two.pressure, one.pressure), 1e-11);
  }
  openblas_set_num_threads(threads);
}

}  // namespace
}  // namespace ffcontact
