// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set/convex_contact.hpp"

#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "support/bodies.hpp"
#include "support/cases.hpp"
#include "support/condensed.hpp"
#include "support/odd_problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

std::string in_figures(const ContactSolution<2>& solution) {
  std::ostringstream text;
  text << in_words(solution.status) << ", violation "
       << solution.complementarity << ", residual " << solution.residual;
  return text.str();
}

RC_GTEST_PROP(ConvexContact,
              alone_solves_every_problem_without_friction_or_with_trescas_law,
              (Random random)) {
  const Condensed c(odd_problem(random, 0));
  const ActiveSetResult result = convex_contact(c.contact, c.law);
  RC_ASSERT(result.status == ContactStatus::converged);
  // what is accepted; 3e-11 is the largest of 12 000 problems
  RC_ASSERT(result.violation <= 1e-10);
  for (std::size_t i = 0; i < result.state.size(); ++i) {
    RC_ASSERT(result.P[2 * i] <= 0);
    RC_ASSERT(std::abs(result.P[2 * i + 1]) <=
              c.law.cone[i].bound(result.P[2 * i]));
  }
}

RC_GTEST_PROP(ConvexContact, ends_where_newton_ends, (Random random)) {
  const Condensed c(odd_problem(random, 0));
  const ActiveSetResult newton =
      active_set_newton(c.contact, c.law, c.sticking);
  RC_PRE(newton.status == ContactStatus::converged);
  const ActiveSetResult convex = convex_contact(c.contact, c.law);
  const double scale = motion_scale(c.contact, newton.v);
  RC_ASSERT((newton.v - convex.v).cwiseAbs().maxCoeff() <= 1e-7 * scale);
}

/// The fixed point would try Newton once more.
TEST(ConvexContact, takes_over_where_newton_ends_without_an_answer) {
  int without_answer = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    Random random(seed);
    const Condensed c(odd_problem(random, 0));
    if (active_set_newton(c.contact, c.law, c.sticking).status ==
        ContactStatus::converged)
      continue;
    ++without_answer;
    const ActiveSetResult convex = solve_convex(c.contact, c.law, c.sticking);
    const ContactSolution<2> solution = solved(c.problem);
    EXPECT_TRUE(solution.accepted({})) << seed;
    // What nothing loads stays, without a system.
    const bool stays = solution.displacement.isZero(0);
    EXPECT_EQ(solution.iterations, stays ? 0 : convex.iterations) << seed;
  }
  EXPECT_GT(without_answer, 3);
}

RC_GTEST_PROP(OddProblems, have_a_solution_that_is_found, (Random random)) {
  const double friction = *rc::gen::element(0.0, 0.0, 0.1);
  const Problem problem = odd_problem(random, friction);
  const ContactSolution<2> solution = solved(problem);
  RC_LOG() << in_figures(solution);
  RC_ASSERT(solution.accepted({}));
}

/// All lengths times one factor, the stiffness and all stresses times another.
ContactSolution<2> solved_scaled(Problem problem, double length,
                                 double stiffness) {
  ElasticSystem system = problem.system();
  system.stiffness *= stiffness;
  system.load *= stiffness * length;
  system.prescribed_value *= length;
  problem.mesh.vertices *= length;
  problem.line.abscissa *= length;
  problem.line.length *= length;
  if (problem.law.gap.size() > 0) problem.law.gap *= length;
  if (problem.law.tresca()) problem.law.slip_bound *= stiffness;
  return solve_contact(problem.mesh, problem.line, problem.law, system);
}

RC_GTEST_PROP(OddProblems, length_and_stiffness_leave_the_answer_as_it_is,
              (Random random)) {
  const double length = *rc::gen::element(1e-9, 1e-3, 1e6),
               stiffness = *rc::gen::element(1e-9, 1e3, 1e6);
  const Problem problem = odd_problem(random, 0);
  const ContactSolution<2> plain = solved(problem),
                           scaled = solved_scaled(problem, length, stiffness);
  RC_LOG() << in_figures(scaled);
  RC_ASSERT(scaled.accepted({}));
  // where all nodes stick, loads move nothing
  const ElasticSystem system = problem.system();
  double size = std::max(plain.displacement.cwiseAbs().maxCoeff(),
                         system.load.cwiseQuotient(system.stiffness.diagonal())
                             .cwiseAbs()
                             .maxCoeff());
  if (problem.law.gap.size() > 0)
    size = std::max(size, problem.law.gap.cwiseAbs().maxCoeff());
  RC_ASSERT((scaled.displacement / length - plain.displacement)
                .cwiseAbs()
                .maxCoeff() <= 1e-7 * size);
}

/// Two walls at a vertex hold it both, and how much each of them bears is not determined.
TEST(ConvexContact, where_multipliers_have_more_than_one_value_one_is_found) {
  Problem problem =
      body(rectangle(1, 1, 1, 1), material(1000, 0.3), {bottom, right});
  clamp(problem, top);
  add_traction(problem, left, {1, -2});
  for (const Multiplier multiplier : {Multiplier::force, Multiplier::pressure})
    for (const double bound : {0.0, 0.1, 10.0}) {
      problem.law.multiplier = multiplier;
      problem.law.slip_bound = everywhere(problem.line, bound);
      const Condensed c(problem);
      EXPECT_EQ(convex_contact(c.contact, c.law).status,
                ContactStatus::converged)
          << bound;
      const ContactSolution<2> solution = solved(problem);
      EXPECT_TRUE(solution.accepted({}))
          << bound << ", " << in_figures(solution);
    }
}

/// A body in which nothing happens but that it moves, or that stands away from the
/// foundation.
TEST(Scales, are_not_those_of_loads_where_there_are_none) {
  for (const Multiplier multiplier : {Multiplier::force, Multiplier::pressure})
    for (const double slip_bound : {-1.0, 0.0, 1.0}) {
      Problem moved =
          body(rectangle(3, 2, 3, 2), material(1000, 0.3), {bottom, right});
      clamp(moved, top, [](const Vector2d&) { return Vector2d(0, 0.1); });
      moved.law.multiplier = multiplier;
      if (slip_bound >= 0)
        moved.law.slip_bound = everywhere(moved.line, slip_bound);
      EXPECT_TRUE(solved(moved).accepted({})) << in_figures(solved(moved));
      Problem apart = moved;
      clamp(apart, top);
      for (const double gap : {0.0, 0.1, 1e-6}) {
        apart.law.gap = everywhere(apart.line, gap);
        EXPECT_TRUE(solved(apart).accepted({}))
            << gap << ", " << in_figures(solved(apart));
      }
    }
}

/// A stiff block that only contact holds on a block softer by many powers of ten: it
/// moves much more than it strains.
TEST(Refinement, a_stiff_body_on_a_soft_one_is_solved_to_rounding) {
  for (const Multiplier multiplier : {Multiplier::force, Multiplier::pressure})
    for (const double E : {7e1, 7.0, 0.1}) {
      Bodies two = bodies({shifted(rectangle(17, 11, 40, 25), {30, 40}),
                           rectangle(33, 13, 100, 40)},
                          {material(210e3, 0.3), material(E, 0.33)},
                          {{0, bottom, 1, top}});
      add_traction(two.problem, two.label(0, top), {4, -20});
      clamp(two.problem, two.label(1, bottom));
      set_friction(two.problem, 0.4);
      two.problem.law.multiplier = multiplier;
      const ContactSolution<2> solution = solved(two.problem);
      EXPECT_TRUE(solution.accepted({})) << E << ", " << in_figures(solution);
      EXPECT_LT(solution.residual, 1e-11) << E;
      const Matrix2Xd& P =
          multiplier == Multiplier::force ? solution.force : solution.pressure;
      // to the bit, after refinement too
      EXPECT_GE((-0.4 * P.row(0) - P.row(1).cwiseAbs()).minCoeff(), 0) << E;
      // what the last place of u weighs
      EXPECT_NEAR(solution.force.row(0).sum(), -800, 5e-6 / E) << E;
    }
}

/// Materials that differ by 1e14 in one body that is held.
TEST(Refinement, contrasts_of_1e14_are_a_matter_of_scaling) {
  Problem problem = body(
      joined(rectangle(4, 4, 1, 1), shifted(rectangle(4, 4, 1, 1), {3, 0})),
      material(1, 0.3), {bottom, 10 + bottom});
  for (std::size_t t = problem.hooke.size() / 2; t < problem.hooke.size(); ++t)
    problem.hooke[t] *= 1e14;
  problem.A = stiffness(problem.mesh, problem.hooke);
  clamp(problem, top);
  clamp(problem, 10 + top);
  add_traction(problem, left, {0.1, -0.1});
  add_traction(problem, 10 + left, {1e13, -1e13});
  const ContactSolution<2> solution = solved(problem);
  EXPECT_TRUE(solution.accepted({})) << in_figures(solution);
}

TEST(MaxIterations, bound_all_systems_of_a_call) {
  Problem problem = example_1(Multiplier::pressure);
  set_friction(problem, 2);
  const int needed = solved(problem).iterations;
  ASSERT_GT(needed, 14);
  for (const ContactSolver solver :
       {ContactSolver::newton, ContactSolver::fixed_point})
    for (const int most : {1, 7, needed / 2}) {
      ContactSettings settings;
      settings.solver = solver;
      settings.max_iterations = most;
      const ContactSolution<2> solution = solved(problem, settings);
      EXPECT_LE(solution.iterations, most);
      EXPECT_FALSE(solution.accepted(settings));
    }
}

}  // namespace
}  // namespace ffcontact
