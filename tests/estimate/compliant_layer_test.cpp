// SPDX-License-Identifier: GPL-3.0-or-later
// The estimate of an interface that gives way.
#include <gtest/gtest.h>

#include <cmath>

#include "support/bodies.hpp"
#include "support/cases.hpp"
#include "support/estimates.hpp"
#include "support/refusals.hpp"
#include "support/solid_estimates.hpp"
#include "support/uniform.hpp"

namespace ffcontact {
namespace {

using namespace test;

CompliantLayer random_layer(double stiffness) {
  return {std::pow(10.0, *real(-2, 1)) / stiffness,
          std::pow(10.0, *real(-2, 1)) / stiffness};
}

/// What the relaxation starts from is by its falls above what it ends at, as an estimate of no
/// steps says: it knows the layer's part of e.
template <class Estimated>
void falls_as_told(const Estimated& estimated) {
  const auto whole = estimated(4);
  RC_ASSERT(whole.admissible);
  RC_ASSERT(whole.equilibrium.largest() < 1e-10);
  RC_ASSERT(whole.history[4] <= whole.history[0]);
  RC_ASSERT(std::abs(estimated(0).e - whole.history[0]) <
            1e-5 * whole.history[0]);
}

RC_GTEST_PROP(CompliantLayer, is_relaxed_with_the_bodies, (Random random)) {
  Bodies two =
      bodies({shifted(with_random_rows(3, 2, 4, 2, random), {0, 3}),
              with_random_rows(4, 2, 4, 3, random)},
             {material(100, 0.3), material(300, 0.2)}, {{0, bottom, 1, top}});
  clamp(two.problem, two.label(1, bottom));
  add_traction(two.problem, two.label(0, top), {1, -2});
  set_friction(two.problem, 1);
  two.problem.law.layer = random_layer(100);
  const ContactSolution<2> solution = solved(two.problem);
  RC_PRE(solution.status == ContactStatus::converged);
  falls_as_told([&](int steps) {
    return estimated(two.problem, solution, sweeps(steps));
  });
}

RC_GTEST_PROP(CompliantLayer, is_relaxed_with_the_solids, (Random random)) {
  SolidProblem problem(irregular_solid(random), 0.3);
  const Vector3d shift = 2e-3 * random_vector(3, random) - Vector3d(0, 0, 3e-3);
  problem.move(high_z, [&](const Vector3d&) { return shift; });
  problem.law.layer = random_layer(13e3);
  const ContactSolution<3> solution = problem.solve();
  RC_PRE(solution.status == ContactStatus::converged);
  falls_as_told([&](int steps) {
    return estimate(problem, solution, {steps, 0});
  });
}

TEST(CompliantLayer, is_not_negative) {
  Problem problem = block_with_three_zones(4);
  problem.law.layer = {-1, 0};
  EXPECT_TRUE(says(refusal([&] { solved(problem); }), "compliance"));
}

}  // namespace
}  // namespace ffcontact
