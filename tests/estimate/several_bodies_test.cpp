// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "support/bodies.hpp"
#include "support/estimates.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr Multiplier both[] = {Multiplier::force, Multiplier::pressure};

TEST(SeveralBodiesEstimate, example_3_as_published) {
  for (const Multiplier multiplier : both) {
    const Bodies two = example_3(multiplier);
    const ContactSolution solution = solved(two.problem);
    const ContactLine& line = two.problem.line;
    const auto ratio = [&](const ContactDensities& r, int end, int e) {
      return std::abs(r.tangential(end, e)) / (-0.3 * r.normal(end, e));
    };
    const ContactDensities before = edge_densities(line, solution.pressure);
    const int last = line.edge_count() - 1;
    if (multiplier == Multiplier::force) {
      EXPECT_GT(std::max(ratio(before, 0, 0), ratio(before, 1, 0)), 1) << "first edge";
      EXPECT_GT(std::max(ratio(before, 0, last), ratio(before, 1, last)), 1) << "last edge";
    }
    for (const Tractions tractions : {Tractions::published, Tractions::fixed, Tractions::free}) {
      const Estimate estimate = estimated(two.problem, solution, sweeps(2, tractions));
      EXPECT_TRUE(estimate.admissible) << estimate.reason;
      if (multiplier == Multiplier::force) EXPECT_EQ(estimate.corrected_count(), 2);
      EXPECT_LT(estimate.relative, tractions == Tractions::free ? 0.08 : 0.086);
    }
  }
}

}  // namespace
}  // namespace ffcontact
