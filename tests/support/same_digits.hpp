// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <omp.h>

#include "support/solid_estimates.hpp"

namespace ffcontact::test {

/// The estimate does not depend on the number of threads, to the last digit.
inline void expect_same_digits_on_two_threads(const SolidProblem& problem) {
  const SurfaceSolution solution = problem.solve();
  const SolidEstimate one = estimate(problem, solution);
  omp_set_num_threads(2);
  const SolidEstimate two = estimate(problem, solution);
  omp_set_num_threads(1);
  EXPECT_EQ(one.e, two.e);
  EXPECT_EQ(one.history, two.history);
  EXPECT_EQ(one.moments, two.moments);
  EXPECT_EQ(one.local, two.local);
  EXPECT_EQ(one.face_tractions, two.face_tractions);
}

}  // namespace ffcontact::test
