// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/continuation/friction_path.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/continuation/friction_curve.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "ffcontact/contact/surface_answer.hpp"
#include "support/condensed_blocks.hpp"
#include "support/pressed_bricks.hpp"
#include "support/solid_defects.hpp"
#include "support/uniform.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// random_problem with friction up to 5, or rough_problem with a multiple of its own.
struct Hard {
  unsigned seed;
  double most_friction, factor;
};

SolidProblem hard_problem(const Hard& hard) {
  Random random(hard.seed);
  if (hard.most_friction > 0) {
    const double mu = Uniform{0, hard.most_friction}(random);
    return random_problem(mu, random);
  }
  SolidProblem problem = rough_problem(random);
  problem.law.friction *= hard.factor;
  return problem;
}

/// Where Newton cycles from all states tried, and the fixed point in g does too.
class HardProblems : public testing::TestWithParam<Hard> {};
INSTANTIATE_TEST_SUITE_P(
    Found, HardProblems,
    testing::Values(Hard{1440941478, 5, 1}, Hard{3061339674, 5, 1},
                    Hard{2602572656, 5, 1}, Hard{3599889581, 0, 3},
                    Hard{2659500828, 0, 30}, Hard{1299021787, 0, 30},
                    Hard{955331645, 0, 30}, Hard{407631198, 0, 30},
                    Hard{3758196824, 0, 300}));

TEST_P(HardProblems, end_on_the_path) {
  const SolidProblem problem = hard_problem(GetParam());
  const ContactSolution<3> solution = problem.solve();
  EXPECT_TRUE(solution.accepted({}));
  EXPECT_TRUE(solution.history.empty());
  EXPECT_LT(defects(problem, solution).largest(), 1e-8);
}

TEST_P(HardProblems, keep_to_the_systems_that_they_are_given) {
  const SolidProblem problem = hard_problem(GetParam());
  for (int most : {205, 212, 230}) {
    ContactSettings settings;
    settings.max_iterations = most;
    EXPECT_LE(problem.solve(settings).iterations, most);
  }
}

/// The solution of the law with less friction, from the solution without.
RC_GTEST_PROP(FrictionCurve, points_are_solutions_with_less_friction,
              (Random random)) {
  const SolidProblem problem = random_problem(*real(0.1, 1), random);
  const CondensedProblem condensed(problem);
  const NodalLaw law = nodal_law(problem.law, problem.surface);
  const ActiveSetResult frictionless = surface_newton(
      condensed.contact, with_share_of_bound(law, 0), condensed.trace.held,
      std::vector<ContactState>(law.node_count(), ContactState::stick));
  FrictionCurve curve(condensed.contact, law, condensed.trace.held,
                      {frictionless.P, frictionless.v}, 100);
  const auto start = curve.start();
  RC_PRE(start.has_value());  // not held by friction alone
  EXPECT_GT(FrictionCurve::share(start->t), 0);
  const auto place = curve.corrected(start->z, start->t, *real(0.01, 0.1));
  RC_PRE(place.has_value());  // beyond a kink it may be shorter
  const NodalLaw share =
      with_share_of_bound(law, FrictionCurve::share(place->z));
  const VectorXd P = surface_answer(condensed.contact, condensed.stiffness,
                                    share, condensed.trace.held, {})
                         .answer.P;
  RC_ASSERT((FrictionCurve::rows(place->z).P - P).norm() < 1e-6 * P.norm());
}

/// A body that friction alone holds has no solution without it.
TEST(FrictionPath, has_no_start_where_friction_alone_holds_a_body) {
  SolidProblem problem(brick({2, 2, 2}, {1, 1, 1}), 0.5);
  problem.load(high_z, {0.1, 0, -1});
  const CondensedProblem condensed(problem);
  const NodalLaw law = nodal_law(problem.law, problem.surface);
  const ActiveSetResult end =
      friction_path(condensed.contact, law, condensed.trace.held, {});
  EXPECT_NE(end.status, ContactStatus::converged);
  EXPECT_TRUE(problem.solve().accepted({}));
}

}  // namespace
}  // namespace ffcontact
