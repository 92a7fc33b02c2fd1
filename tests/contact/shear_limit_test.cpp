// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/law/nodal_law.hpp"
#include "support/cases.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// What is left of |F_t| <= min(-mu F_n, k len), of slip against F_t at the bound, and of
/// stick below it, relative to the forces.
double worst_of(const Problem& problem, const ContactSolution<2>& solution) {
  const Matrix2Xd w = displacement_against_foundation(problem.line, problem.law,
                                                      solution.displacement);
  const VectorXd length =
      contact_mass(problem.line) * VectorXd::Ones(problem.line.node_count());
  const double force = solution.force.cwiseAbs().maxCoeff(),
               motion = solution.displacement.cwiseAbs().maxCoeff();
  double worst = 0;
  for (int i = 0; i < problem.line.node_count(); ++i) {
    const double Fn = solution.force(0, i), Ft = solution.force(1, i),
                 slip = w(1, i) / motion;
    const double bound = std::min(-problem.law.friction[i] * Fn,
                                  problem.law.shear_limit[i] * length[i]);
    const double below = (bound - std::abs(Ft)) / force;
    worst = std::max(
        {worst, -below, std::min(below, std::abs(slip)), slip * Ft / force});
  }
  return worst;
}

/// A random problem of nodal forces whose shear limit is reached at some of its nodes.
Problem limited_problem(double mu, double share) {
  Case c = *random_case(mu);
  c.multiplier = Multiplier::force;
  Problem problem = problem_of(c);
  const ContactSolution<2> unlimited = solved(problem);
  const VectorXd length =
      contact_mass(problem.line) * VectorXd::Ones(problem.line.node_count());
  const double largest =
      (unlimited.force.row(1).transpose().cwiseAbs().cwiseQuotient(length))
          .maxCoeff();
  problem.law.shear_limit = everywhere(problem.line, share * largest);
  return problem;
}

RC_GTEST_PROP(ShearLimit, is_obeyed_with_friction_below_it, ()) {
  const Problem problem = limited_problem(2, *real(0.05, 1.2));
  const ContactSolution<2> solution = solved(problem);
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(worst_of(problem, solution) < 1e-9);
}

RC_GTEST_PROP(ShearLimit, is_reached_by_the_fixed_point_too, ()) {
  const Problem problem = limited_problem(0.4, *real(0.2, 1));
  ContactSettings settings;
  const ContactSolution<2> newton = solved(problem, settings);
  settings.solver = ContactSolver::fixed_point;
  const ContactSolution<2> path = solved(problem, settings);
  RC_ASSERT(path.accepted({}));
  RC_ASSERT(relative_difference(path.displacement, newton.displacement) < 1e-7);
}

TEST(ShearLimit, that_nothing_reaches_is_coulombs_law_to_the_bit) {
  for (const Multiplier multiplier :
       {Multiplier::force, Multiplier::pressure}) {
    Problem problem = example_1(multiplier);
    const ContactSolution<2> coulomb = solved(problem);
    problem.law.shear_limit = everywhere(problem.line, 1e6);
    EXPECT_EQ(solved(problem).displacement, coulomb.displacement);
  }
}

TEST(ShearLimit, far_below_friction_is_trescas_law_where_the_line_is_closed) {
  for (const Multiplier multiplier :
       {Multiplier::force, Multiplier::pressure}) {
    Problem problem = body(rectangle(16, 8, 80, 40), material(13e3, 0.2));
    add_traction(problem, top, {0, -10});
    prescribe(problem, left, 0,
              [](const Vector2d&) { return Vector2d(0.1, 0); });
    problem.law.multiplier = multiplier;
    set_friction(problem, 1);
    problem.law.shear_limit = everywhere(problem.line, 0.5);
    const ContactSolution<2> limited = solved(problem);
    problem.law.shear_limit = {};
    problem.law.slip_bound = everywhere(problem.line, 0.5);
    const ContactSolution<2> tresca = solved(problem);
    ASSERT_LT(tresca.pressure.row(0).maxCoeff(), -0.5);
    EXPECT_LT(relative_difference(limited.displacement, tresca.displacement),
              1e-10);
    for (ContactState state : limited.state)
      EXPECT_TRUE(state == ContactState::slip_forward);
  }
}

TEST(ShearLimit, of_a_node_is_in_the_units_of_the_multiplier) {
  Problem problem =
      example_1(Multiplier::pressure, 2);  // four edges of 20 mm, mu 0.5
  problem.law.shear_limit = everywhere(problem.line, 3);
  EXPECT_EQ(nodal_law(problem.law, problem.line).cone[1].bound(-4), 2);
  EXPECT_EQ(nodal_law(problem.law, problem.line).cone[1].bound(-7), 3);
  problem.law.multiplier = Multiplier::force;
  EXPECT_DOUBLE_EQ(nodal_law(problem.law, problem.line).cone[1].bound(-700),
                   60);
}

TEST(ShearLimit, refuses_what_does_not_fit) {
  Problem problem = example_1(Multiplier::force, 2);
  problem.law.shear_limit = everywhere(problem.line, -1);
  EXPECT_EQ(refusal([&] { solved(problem); }).substr(0, 11), "shear limit");
  problem.law.shear_limit = VectorXd::Ones(2);
  EXPECT_EQ(refusal([&] { solved(problem); }).substr(0, 11), "shear limit");
  problem.law.shear_limit = everywhere(problem.line, 1);
  problem.law.slip_bound = everywhere(problem.line, 1);
  EXPECT_EQ(refusal([&] { solved(problem); }),
            "a shear limit belongs to Coulomb's law, not to Tresca's");
}

}  // namespace
}  // namespace ffcontact
