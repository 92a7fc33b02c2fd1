// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "support/estimates.hpp"
#include "support/pins.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The estimate of a pin that is held against noise.
Estimate<2> estimate_of_held(Problem problem) {
  const BodyLoadsOfCells<2> loads = held(problem);
  add_body_loads(problem.mesh, loads, problem.b);
  const ElasticSystem system = problem.system();
  SolvedBody<2> body = solved_body(
      problem, solve_contact(problem.mesh, problem.line, problem.law, system));
  if (loads.cols() > 0) body.body_loads += loads;
  return estimate_error<2>(topology_of(problem.mesh), problem.line, system,
                           body);
}

/// The moment about its axis, which r_hat has by what noise gives it for arms, is held: the
/// tractions do not balance it.
TEST(SlidingPin, noise_of_coordinates_does_not_change_its_error) {
  const Estimate<2> exact = estimate_of_held(pin(0));
  ASSERT_TRUE(exact.admissible) << exact.reason;
  for (const double noise : {1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5})
    for (const unsigned seed : {1U, 2U, 3U}) {
      const Estimate<2> found = estimate_of_held(pin(noise, seed));
      EXPECT_TRUE(found.admissible) << found.reason;
      EXPECT_NEAR(found.relative / exact.relative, 1, 0.01) << noise;
    }
}

}  // namespace
}  // namespace ffcontact
