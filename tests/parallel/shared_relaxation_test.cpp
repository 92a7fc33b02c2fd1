// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/shared_relaxation.hpp"

#include <gtest/gtest.h>

#include "support/relaxed_solid.hpp"
#include "support/threads_as_processes.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Sums of another order differ in their last digits, single precision makes more of that.
constexpr double digits = 1e-5;

RC_GTEST_PROP(SharedRelaxation, is_that_of_one_process, (Random random)) {
  RelaxedSolid solid(any_solid(random));
  FaceMoments shared = solid.moments;
  const int processes = 1 + static_cast<int>(random() % 4), steps = 6;
  const std::vector<double> falls =
      relaxed_by(processes, random() % 2 == 0, static_cast<unsigned>(random()))(
          solid.setting, {steps, 0}, shared);
  const double square = solid.square();
  const std::vector<double> alone = solid.relax(steps);
  RC_ASSERT(falls.size() == alone.size());
  for (std::size_t k = 0; k < falls.size(); ++k)
    RC_ASSERT(std::abs(falls[k] - alone[k]) < digits * square);
  RC_ASSERT((shared - solid.moments).norm() < digits * shared.norm());
}

TEST(SharedRelaxation, has_the_same_digits_in_one_part) {
  Random random(3);
  RelaxedSolid solid(any_solid(random));
  FaceMoments shared = solid.moments;
  const std::vector<double> falls =
      relaxed_by(1, true, 1)(solid.setting, {5, 0}, shared);
  EXPECT_EQ(solid.relax(5), falls);
  EXPECT_EQ(solid.moments, shared);
}

}  // namespace
}  // namespace ffcontact
