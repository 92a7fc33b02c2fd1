// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/estimate/facing_error.hpp"
#include "support/nested_solids.hpp"
#include "support/solid_estimates.hpp"
#include "support/solid_stacks.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// |sigma_hat - C eps(u_hat)| as a part of |2 sigma|.
double elastic_share(const SolidEstimate& found) {
  return found.elastic * found.relative / found.e;
}

RC_GTEST_PROP(FacingSolids, a_uniform_pressure_has_no_error, (Random random)) {
  SolidStack stack = random_stack(*rc::gen::inRange(2, 4), *real(0, 1), random);
  put_between_walls(stack);
  stack.problem.load(stack.label(0, high_z), {0, 0, -10});
  const SolidEstimate found = estimate(stack.problem);
  RC_ASSERT(found.reason == "");
  RC_ASSERT(elastic_share(found) < 1e-11);
  RC_ASSERT(found.relative < 1e-6);
  RC_ASSERT(found.oscillation < 1e-9);
}

RC_GTEST_PROP(FacingSolids, are_admissible, (Random random)) {
  const SolidStack stack = random_solids(*real(0, 2), random);
  const SolidEstimate found = estimate(stack.problem);
  RC_ASSERT(found.reason == "");
  RC_ASSERT(found.equilibrium.largest() < 1e-10);
  RC_ASSERT(found.cone < 1e-13);
  RC_ASSERT(found.penetration < 1e-13);
  RC_ASSERT(found.contact > -1e-12 * found.e * found.e);
}

/// Pressed on its mirror image a body feels a smooth rigid foundation.
RC_GTEST_PROP(FacingSolids, mirror_images_have_twice_the_square,
              (Random random)) {
  const SolidMesh upper = moved(brick({3, 2, 2}, {3, 2, 2}), 1, 0.15, random);
  SolidMesh lower = upper;
  lower.vertices.row(2) *= -1;
  lower.cells.row(0).swap(lower.cells.row(1));
  for (int& label : lower.boundary_label)
    label = label == low_z ? high_z : label == high_z ? low_z : label;
  const auto press = [](SolidProblem& problem, int side, double sign) {
    problem.move(side, [&](const Vector3d& x) {
      return Vector3d(1e-3 * x.y(), 0, sign * (-2e-3 + 3e-3 * x.x()));
    });
  };
  SolidProblem one(upper, 0);
  press(one, high_z, 1);
  SolidStack two({upper, lower}, 0.5);
  press(two.problem, two.label(0, high_z), 1);
  press(two.problem, two.label(1, low_z), -1);
  const SolidEstimate alone = estimate(one), both = estimate(two.problem);
  RC_ASSERT(both.reason == "");
  RC_ASSERT(both.oscillation < 1e-9 * both.e);
  RC_ASSERT(std::abs(both.e / (std::sqrt(2) * alone.e) - 1) < 1e-6);
  RC_ASSERT(std::abs(both.relative / alone.relative - 1) < 1e-6);
}

}  // namespace
}  // namespace ffcontact
