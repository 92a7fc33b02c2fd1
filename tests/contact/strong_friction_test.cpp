// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "ffcontact/contact/fixed_point/fixed_point.hpp"
#include "support/cases.hpp"
#include "support/condensed.hpp"
#include "support/odd_problems.hpp"
#include "support/uniform.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(StrongFriction, is_solved_and_certified, ()) {
  const ContactSettings settings;
  const Case c = *random_case(3);
  const ContactSolution<2> solution = solved(problem_of(c), settings);
  RC_ASSERT(solution.accepted(settings));
}

RC_GTEST_PROP(StrongFriction,
              violation_and_residual_decide_the_status_of_a_run_cut_short, ()) {
  ContactSettings settings;
  settings.max_iterations = *rc::gen::inRange(1, 4);
  settings.solver =
      *rc::gen::element(ContactSolver::newton, ContactSolver::fixed_point);
  const ContactSolution<2> solution =
      solved(problem_of(*random_case(3)), settings);
  const bool within = solution.complementarity <= settings.tolerance &&
                      solution.residual <= settings.tolerance;
  RC_ASSERT(within == (solution.status == ContactStatus::converged));
  RC_ASSERT(solution.displacement.allFinite());
}

TEST(StrongFriction, example_1_up_to_friction_3) {
  for (const Multiplier multiplier : {Multiplier::force, Multiplier::pressure})
    for (double mu = 0.25; mu <= 3; mu += 0.25) {
      Problem problem = example_1(multiplier);
      set_friction(problem, mu);
      EXPECT_TRUE(solved(problem).accepted({}))
          << "mu " << mu << ", multiplier " << static_cast<int>(multiplier);
    }
}

TEST(StrongFriction,
     example_1_where_newton_from_stick_cycles_the_fixed_point_leads_the_way) {
  Problem problem = example_1(Multiplier::pressure);
  set_friction(problem, 2);
  const Condensed c(problem);
  EXPECT_EQ(active_set_newton(c.contact, c.law, c.sticking).status,
            ContactStatus::cycled);
  const FixedPointResult alone =
      fixed_point(c.contact, c.law, c.sticking, {10000, 1e-10});
  const FixedPointResult helped =
      fixed_point(c.contact, c.law, c.sticking, {10000, 1e-10}, true);
  EXPECT_EQ(alone.answer.status, ContactStatus::converged);
  EXPECT_EQ(helped.answer.status, ContactStatus::converged);
  EXPECT_LT(2 * helped.answer.iterations, alone.answer.iterations);
  EXPECT_LT(relative_difference(helped.answer.v, alone.answer.v), 1e-8);
}

TEST(StrongFriction,
     a_fixed_point_cut_short_leaves_the_better_answer_of_newton) {
  Problem problem = example_1(Multiplier::pressure);
  set_friction(problem, 2);
  const Condensed c(problem);
  const ActiveSetResult newton =
      active_set_newton(c.contact, c.law, c.sticking);
  ContactSettings settings;
  settings.max_iterations = newton.iterations + 1;
  const ContactSolution<2> solution = solved(problem, settings);
  EXPECT_EQ(solution.iterations, settings.max_iterations);
  EXPECT_LT(solution.complementarity, 1.01 * newton.violation);
}

/// A roller moves the end of the line against a foundation whose friction it does not feel:
/// mu times its pressure there is 1e20 MPa, and must not be what all else is small against.
TEST(StrongFriction, that_loads_nothing_is_no_scale_for_what_does) {
  Problem problem = body(rectangle(4, 4, 4, 4), material(1000, 0.3));
  prescribe(problem, left, 0,
            [](const Vector2d&) { return Vector2d(1e-4, 0); });
  add_traction(problem, top, {0, -2});
  set_friction(problem, 1e3);
  const ContactSolution<2> rough = solved(problem);
  ASSERT_TRUE(rough.accepted({}));
  for (const double mu : {1e8, 1e12, 1e20}) {
    set_friction(problem, mu);
    const ContactSolution<2> solution = solved(problem);
    EXPECT_TRUE(solution.accepted({})) << mu;
    EXPECT_LT(relative_difference(solution.displacement, rough.displacement),
              1e-8)
        << mu;
  }
}

/// Without damping it swings until 1000 systems are used up.
TEST(StrongFriction,
     damping_makes_the_fixed_point_converge_where_it_does_not_contract) {
  for (const unsigned seed : {3, 81, 94}) {
    Random random(seed);
    const Condensed c(odd_problem(random, 4));
    const FixedPointResult path =
        fixed_point(c.contact, c.law, c.sticking, {1000, 1e-10});
    EXPECT_EQ(path.answer.status, ContactStatus::converged) << seed;
    EXPECT_LT(path.answer.iterations, 400) << seed;
  }
}

/// Zones of a quarter of the mesh that are refined five times, so that edges differ by
/// 2^5 on the line.
TEST(StrongFriction, randomly_refined_mesh) {
  std::mt19937 random(7);
  Mesh mesh = rectangle(16, 8, 80, 40);
  const Uniform along{0, 80};
  for (int level = 0; level < 5; ++level)
    mesh = refined(
        mesh, triangles_near(mesh, {along(random), 0}, 5 / std::pow(2, level)));
  for (const Multiplier multiplier : {Multiplier::force, Multiplier::pressure})
    for (const double mu : {0.3, 1.0, 2.0, 3.0}) {
      Problem problem = body(mesh, material(13e3, 0.2));
      add_traction(problem, left, {10, 0});
      clamp(problem, top);
      prescribe(problem, right, 0);
      set_friction(problem, mu);
      problem.law.multiplier = multiplier;
      const ContactSolution<2> solution = solved(problem);
      EXPECT_TRUE(solution.accepted({}))
          << "mu " << mu << ", multiplier " << static_cast<int>(multiplier)
          << ", " << in_words(solution.status) << ", violation "
          << solution.complementarity;
    }
}

}  // namespace
}  // namespace ffcontact
