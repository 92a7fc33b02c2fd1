// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/balance.hpp"
#include "support/cases.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

class HeldBodies : public testing::TestWithParam<Multiplier> {};
INSTANTIATE_TEST_SUITE_P(Multipliers, HeldBodies,
                         testing::Values(Multiplier::force,
                                         Multiplier::pressure));

/// A free block 6 x 4 on a plane.
Problem block(Multiplier multiplier, double mu) {
  Problem problem = body(rectangle(6, 4, 6, 4), material(1000, 0.3));
  set_friction(problem, mu);
  problem.law.multiplier = multiplier;
  return problem;
}

TEST(UnheldMotions, are_none_translation_rotation_or_all_three) {
  Problem problem = block(Multiplier::force, 0);
  const int corner = 0, along = 2 * 6;  // the bottom's ends
  EXPECT_EQ(unheld_motions(problem.mesh, problem.system()).cols(), 3);
  Problem pinned = problem;
  prescribe_dof(pinned, 2 * corner, 0);
  prescribe_dof(pinned, 2 * corner + 1, 0);
  const ElasticSystem system = pinned.system();
  ASSERT_EQ(unheld_motions(pinned.mesh, system).cols(), 1);
  Problem guided = problem;
  prescribe(guided, right, 0);
  EXPECT_EQ(unheld_motions(guided.mesh, guided.system()).cols(), 1);
  prescribe_dof(pinned, along + 1, 0);
  EXPECT_EQ(unheld_motions(pinned.mesh, pinned.system()).cols(), 0);
}

TEST(UnheldMotions, a_weak_spring_holds_too) {
  Problem problem = block(Multiplier::force, 0);
  prescribe(problem, right, 0);
  EXPECT_EQ(unheld_motions(problem.mesh, problem.system()).cols(), 1);
  problem.A.coeffRef(1, 1) += 1e-5;
  EXPECT_EQ(unheld_motions(problem.mesh, problem.system()).cols(), 0);
}

TEST_P(HeldBodies, held_by_contact_alone_with_friction) {
  Problem problem = block(GetParam(), 0.5);
  add_traction(problem, top, {0.2, -1});
  const ContactSolution<2> solution = solved(problem);
  EXPECT_TRUE(solution.accepted({})) << in_words(solution.status);
  EXPECT_NEAR(solution.force.row(0).sum(), -6, 1e-9);
  EXPECT_NEAR(solution.force.row(1).sum(), -1.2, 1e-9);
}

TEST_P(HeldBodies,
       on_a_frictionless_plane_balanced_loads_leave_one_motion_undetermined) {
  Problem problem = block(GetParam(), 0);
  add_traction(problem, top, {0, -1});
  const ContactSolution<2> solution = solved(problem);
  EXPECT_TRUE(solution.accepted({}))
      << in_words(solution.status) << ", residual " << solution.residual;
  EXPECT_NEAR(solution.force.row(0).sum(), -6, 1e-9);
}

TEST_P(HeldBodies,
       pulled_back_by_tractions_that_balance_on_a_frictionless_plane) {
  Problem problem = block(GetParam(), 0);
  add_traction(problem, top, {0, -1});
  add_traction(problem, left, {-0.3, 0});
  add_traction(problem, right, {0.3, 0});
  EXPECT_TRUE(solved(problem).accepted({}));
}

TEST_P(HeldBodies, a_rotation_that_contact_cannot_oppose_is_named) {
  Problem problem = block(GetParam(), 2);
  add_traction(problem, top, {0, -1});
  // moment 24 about the far corner against 18 of the weight
  add_traction(problem, left, {3, 0});
  EXPECT_TRUE(says(refusal([&] { solved(problem); }), "rotation about"));
}

/// Nodal forces may all be at one end of the line, the forces of pressures <= 0 cannot.
TEST(HeldBodiesByPressure,
     resultants_that_only_a_force_at_the_very_end_balances_are_refused) {
  for (const Multiplier multiplier :
       {Multiplier::force, Multiplier::pressure}) {
    Problem problem = block(multiplier, 0);
    problem.b[2 * 6 + 1] = -1;  // straight down on the right end of the line
    const std::string sentence = refusal([&] { solved(problem); });
    EXPECT_EQ(sentence == "accepted", multiplier == Multiplier::force)
        << sentence;
  }
}

}  // namespace
}  // namespace ffcontact
