// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/continuation/spring_path.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "support/pressed_bricks.hpp"
#include "support/refusals.hpp"
#include "support/solid_defects.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Nothing where the loads exceed all friction at once, which is refused.
std::optional<ContactSolution<3>> resting(
    const SolidProblem& problem, const ContactSettings& settings = {}) {
  std::optional<ContactSolution<3>> solution;
  const std::string said = refusal([&] { solution = problem.solve(settings); });
  EXPECT_TRUE(solution || says(said, "no equilibrium"));
  return solution;
}

/// A body that friction alone holds finds its place, or slides.
RC_GTEST_PROP(SpringPath, bodies_at_rest_are_found, (Random random)) {
  const SolidProblem problem = resting_problem(random);
  const std::optional<ContactSolution<3>> solution = resting(problem);
  RC_PRE(solution.has_value());
  const bool rests = solution->accepted({});
  RC_CLASSIFY(rests);
  RC_ASSERT(rests || solution->status == ContactStatus::singular);
  if (rests) RC_ASSERT(defects(problem, *solution).largest() < 1e-8);
}

TEST(SpringPath, keeps_to_the_systems_that_it_is_given) {
  int used_up = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const SolidProblem problem = resting_problem(random);
    for (int most : {40, 70, 100}) {
      ContactSettings settings;
      settings.max_iterations = most;
      if (const auto solution = resting(problem, settings)) {
        EXPECT_LE(solution->iterations, most) << seed;
        used_up += solution->iterations == most;
      }
    }
  }
  EXPECT_GT(used_up, 0);
}

}  // namespace
}  // namespace ffcontact
