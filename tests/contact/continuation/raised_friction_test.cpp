// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/continuation/raised_friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "support/condensed_blocks.hpp"
#include "support/pressed_bricks.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Tresca's law has one solution, whatever the way there.
RC_GTEST_PROP(RaisedFriction, ends_at_the_solution_with_a_given_bound,
              (Random random)) {
  SolidProblem problem = random_problem(0, random);
  problem.law.slip_bound =
      *real(0, 2) *
      random_vector(problem.surface.node_count(), random).cwiseAbs();
  const CondensedProblem condensed(problem);
  const auto& [trace, stiffness, contact] = condensed;
  const NodalLaw law = nodal_law(problem.law, problem.surface);
  StepSolver solver;
  CondensedRelation relation(contact, solver);
  const ActiveSetResult end = raised_friction(relation, law, trace.held, {}),
                        newton = surface_newton(
                            contact, law, trace.held,
                            std::vector<ContactState>(law.node_count(),
                                                      ContactState::stick));
  RC_PRE(newton.status == ContactStatus::converged);
  RC_ASSERT(end.status == ContactStatus::converged);
  RC_ASSERT(end.violation <= 1e-10);
  RC_ASSERT((end.v - newton.v).norm() <= 1e-9 * newton.v.norm());
}

/// Refuses steps that change friction much.
class Balking : public CondensedRelation {
 public:
  Balking(const CondensedContact& contact, StepSolver& solver, double most)
      : CondensedRelation(contact, solver), most_(most) {}

  SystemKind step(const SurfaceEquations& equations,
                  ContactRows& rows) override {
    ContactRows next = rows;
    const SystemKind kind = CondensedRelation::step(equations, next);
    double change = 0;
    for (int i = 0; 3 * i < rows.P.size(); ++i)
      change = std::max(change, (next.P - rows.P).segment<2>(3 * i + 1).norm());
    if (change > most_) return SystemKind::inconsistent;
    rows = next;
    return kind;
  }

 private:
  double most_;
};

TEST(RaisedFriction, goes_by_smaller_raises_where_newton_fails) {
  Random random(1);
  SolidProblem problem = random_problem(0, random);
  problem.law.slip_bound = VectorXd::Ones(problem.surface.node_count());
  const CondensedProblem condensed(problem);
  const NodalLaw law = nodal_law(problem.law, problem.surface);
  double bound = 0;
  for (const FrictionCone& cone : law.cone)
    bound = std::max(bound, cone.cohesion);
  StepSolver solver;
  for (double share : {0.2, 0.1, 0.05}) {
    Balking relation(condensed.contact, solver, share * bound);
    const ActiveSetResult end =
        raised_friction(relation, law, condensed.trace.held, {2000});
    EXPECT_EQ(end.status, ContactStatus::converged) << share;
    EXPECT_LT(end.violation, 1e-10);
  }
}

TEST(RaisedFriction, keeps_to_the_systems_that_it_is_given) {
  Random random(1);
  SolidProblem problem = random_problem(0.5, random);
  const CondensedProblem condensed(problem);
  const NodalLaw law = nodal_law(problem.law, problem.surface);
  StepSolver solver;
  CondensedRelation relation(condensed.contact, solver);
  for (int most = 1; most < 8; ++most) {
    const ActiveSetResult end = raised_friction(
        relation, law, condensed.trace.held, NewtonSettings{most});
    EXPECT_LE(end.iterations, most);
    EXPECT_TRUE(end.status == ContactStatus::converged ||
                std::isinf(end.violation));
  }
}

}  // namespace
}  // namespace ffcontact
