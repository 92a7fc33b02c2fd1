// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "support/solid_estimates.hpp"
#include "support/threads.hpp"

namespace ffcontact::test {

/// The estimate does not depend on the number of threads, to the last digit.
inline void expect_same_digits_on_two_threads(const SolidProblem& problem) {
  const ContactSolution<3> solution = problem.solve();
  const auto on = [&](int threads) {
    return on_threads(threads, [&] { return estimate(problem, solution); });
  };
  const Estimate<3> one = on(1), two = on(2);
  EXPECT_EQ(one.e, two.e);
  EXPECT_EQ(one.history, two.history);
  EXPECT_EQ(one.moments, two.moments);
  EXPECT_EQ(one.local, two.local);
  EXPECT_EQ(one.face_tractions, two.face_tractions);
}

}  // namespace ffcontact::test
