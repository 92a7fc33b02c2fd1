// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies whose traces do not match: the bound (2.20) against nested references, and
// convergence to matching traces.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/bodies.hpp"
#include "support/nested_reference.hpp"

namespace ffcontact::test {
namespace {

/// A block on a longer one, sheared; cells along the interface in the ratio 5 : 7.
Problem sheared(int ratio, double slip_bound, Multiplier multiplier) {
  Bodies two = bodies({shifted(rectangle(5 * ratio, 3 * ratio, 5, 3), {1, 4}),
                       rectangle(7 * ratio, 4 * ratio, 8, 4)},
                      {material(70e3, 0.3), material(120e3, 0.2)},
                      {{0, bottom, 1, top}});
  Problem& problem = two.problem;
  add_traction(problem, two.label(0, top), {3, -10});
  clamp(problem, two.label(1, bottom));
  prescribe(problem, two.label(0, right), 0);
  if (slip_bound > 0)
    problem.law.slip_bound = everywhere(problem.line, slip_bound);
  problem.law.multiplier = multiplier;
  return problem;
}

TEST(two_bodies, bound_holds_for_tresca_and_without_friction) {
  for (const double slip_bound : {0.0, 1.0, 4.0})
    for (const Multiplier multiplier :
         {Multiplier::force, Multiplier::pressure}) {
      const Problem coarse = sheared(1, slip_bound, multiplier),
                    fine = sheared(12, slip_bound, multiplier);
      const ContactSolution<2> solution = solved(coarse),
                               reference = solved(fine);
      ASSERT_TRUE(solution.accepted({}) && reference.accepted({}));
      const Estimate<2> estimate = estimated(coarse, solution, sweeps(2));
      ASSERT_TRUE(estimate.admissible) << estimate.reason;
      ASSERT_TRUE(estimate.refinement.has_value());
      const SquaredDistances squares =
          squared_distances(coarse, estimate, fine, reference.displacement);
      std::printf("k %.1f: %.4e + %.4e <= %.4e\n", slip_bound, squares.stress,
                  squares.displacement, estimate.e * estimate.e);
      EXPECT_LE(squares.stress + squares.displacement, estimate.e * estimate.e);
    }
}

/// Energies of example 3 on meshes that match and that do not.
TEST(two_bodies, matching_and_non_matching_answers_converge_to_each_other) {
  for (const Multiplier multiplier :
       {Multiplier::force, Multiplier::pressure}) {
    double difference = 0;
    for (const int n : {2, 4, 8}) {
      const auto energy = [&](int lower) {
        const Bodies two = example_3(multiplier, 8 * n, lower * n);
        EXPECT_EQ(two.problem.line.matches(), lower == 16);
        const ContactSolution<2> solution = solved(two.problem);
        EXPECT_TRUE(solution.accepted({}));
        return two.problem.system().load.dot(solution.displacement);
      };
      const double matching = energy(16), before = difference;
      difference = std::abs(energy(17) / matching - 1);
      std::printf("%d cells: energy %.8e, relative difference %.3e\n", 8 * n,
                  matching, difference);
      if (n > 2) {
        EXPECT_LT(difference, before / 1.9);
      }
    }
  }
}

}  // namespace
}  // namespace ffcontact::test
