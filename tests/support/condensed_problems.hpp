// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/bodies.hpp"
#include "support/random.hpp"

/// Problems whose condensed relations have primary and dependent rows.
namespace ffcontact::test {

/// A rectangle in contact on two sides that meet in a corner, with a gap and a previous
/// displacement.
inline Problem cornered_body(Random& random, Multiplier multiplier) {
  Problem problem =
      body(irregular(4, 3, 4, 3, random), material(100, 0.3), {bottom, left});
  add_traction(problem, top, {-1, -2});
  clamp(problem, right,
        [](const Vector2d& x) { return Vector2d(-0.01, 0.01 * x.y()); });
  problem.law.multiplier = multiplier;
  problem.law.gap = 0.01 * random_vector(problem.line.node_count(), random);
  problem.law.previous =
      0.01 * random_vector(problem.line.node_count(), random);
  return problem;
}

/// Two bodies whose nodes do not match, the first one held along the line at its end,
/// where the second one may move.
inline Problem facing_bodies(Random& random, Multiplier multiplier) {
  Bodies two =
      bodies({shifted(with_random_rows(3, 2, 4, 2, random), {0, 3}),
              with_random_rows(4, 2, 4, 3, random)},
             {material(100, 0.3), material(300, 0.2)}, {{0, bottom, 1, top}});
  prescribe(two.problem, two.label(0, left), 0);
  clamp(two.problem, two.label(1, bottom));
  add_traction(two.problem, two.label(0, top), {1, -2});
  add_traction(two.problem, two.label(1, right), {3, 1});
  two.problem.law.multiplier = multiplier;
  return two.problem;
}

}  // namespace ffcontact::test
