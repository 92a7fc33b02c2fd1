// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/multiplier_method.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "support/condensed_blocks.hpp"
#include "support/pressed_bricks.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Nothing but the problem is the same as in surface_newton: displacements are unique.
void expect_newtons_answer(const SolidProblem& problem) {
  const CondensedProblem condensed(problem);
  const auto& [trace, stiffness, contact] = condensed;
  const NodalLaw law = nodal_law(problem.law, problem.surface);
  const ContactStates stick(law.node_count(), ContactState::stick);
  const ActiveSetResult newton =
      surface_newton(contact, law, trace.held, stick);
  RC_PRE(newton.status == ContactStatus::converged);
  const ActiveSetResult minimum =
      multiplier_method(contact, stiffness, law, trace.held, {1000});
  RC_ASSERT(minimum.status == ContactStatus::converged);
  RC_ASSERT(minimum.violation <= 1e-10);
  // where all nodes stick v is 0 but for the rounding of bodies that move by 1e-3 mm
  constexpr double rounding = 1e-15;
  RC_ASSERT((minimum.v - newton.v).norm() <= 1e-8 * newton.v.norm() + rounding);
  RC_ASSERT((minimum.P - newton.P).norm() <= 1e-8 * newton.P.norm());
}

RC_GTEST_PROP(MultiplierMethod, finds_the_solution_without_friction,
              (Random random)) {
  expect_newtons_answer(random_problem(0, random));
}

RC_GTEST_PROP(MultiplierMethod, finds_the_solution_with_a_given_bound,
              (Random random)) {
  SolidProblem problem = random_problem(0, random);
  problem.law.slip_bound =
      *real(0, 2) *
      random_vector(problem.surface.node_count(), random).cwiseAbs();
  expect_newtons_answer(problem);
}

/// Prescribed and gaps of any size; held by contact alone.
RC_GTEST_PROP(MultiplierMethod, finds_it_for_bodies_that_contact_alone_holds,
              (Random random)) {
  SolidProblem problem = resting_problem(random);
  problem.law.friction.setZero();
  problem.law.previous.resize(2, 0);
  problem.guide(low_x, 0);
  problem.guide(low_x, 1);
  expect_newtons_answer(problem);
}

TEST(MultiplierMethod, keeps_to_the_systems_that_it_is_given) {
  Random random(1);
  const SolidProblem problem = random_problem(0, random);
  const CondensedProblem condensed(problem);
  const NodalLaw law = nodal_law(problem.law, problem.surface);
  for (int most = 1; most < 8; ++most) {
    const ActiveSetResult end =
        multiplier_method(condensed.contact, condensed.stiffness, law,
                          condensed.trace.held, {most});
    EXPECT_LE(end.iterations, most);
    EXPECT_EQ(end.status == ContactStatus::converged, end.violation <= 1e-10);
  }
}

}  // namespace
}  // namespace ffcontact
