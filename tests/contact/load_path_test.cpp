// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/interface/nearest_nodes.hpp"
#include "support/cases.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

VectorXd tangential_displacement(const Problem& problem,
                                 const ContactSolution<2>& solution) {
  return contact_components(problem.line, solution.displacement).row(1);
}

/// A block pressed down and then sheared by its top, which leaves a part of the line
/// sticking.
Problem sheared_block(Multiplier multiplier, double shear) {
  Problem problem = body(rectangle(16, 8, 40, 20), material(13e3, 0.2));
  clamp(problem, top, [=](const Vector2d&) { return Vector2d(shear, -0.02); });
  set_friction(problem, 0.3);
  problem.law.multiplier = multiplier;
  return problem;
}

class LoadPath : public testing::TestWithParam<Multiplier> {};
INSTANTIATE_TEST_SUITE_P(Multipliers, LoadPath,
                         testing::Values(Multiplier::force,
                                         Multiplier::pressure));

TEST_P(LoadPath, starting_from_rest_is_the_static_law_to_the_bit) {
  Problem problem = sheared_block(GetParam(), 0.01);
  const ContactSolution<2> at_once = solved(problem);
  problem.law.previous = everywhere(problem.line, 0);
  EXPECT_EQ(solved(problem).displacement, at_once.displacement);
}

TEST_P(LoadPath, a_step_without_a_change_changes_nothing) {
  Problem problem = sheared_block(GetParam(), 0.01);
  const ContactSolution<2> before = solved(problem);
  EXPECT_GT(std::count(before.state.begin(), before.state.end(),
                       ContactState::slip_forward),
            0);
  problem.law.previous = tangential_displacement(problem, before);
  const ContactSolution<2> after = solved(problem);
  EXPECT_TRUE(after.accepted({}));
  EXPECT_LT(relative_difference(after.displacement, before.displacement),
            1e-12);
  EXPECT_LT(relative_difference(after.force, before.force), 1e-11);
}

TEST_P(
    LoadPath,
    sheared_back_and_forth_friction_keeps_the_memory_that_the_static_law_has_not) {
  Problem forth = sheared_block(GetParam(), 0.05),
          back = sheared_block(GetParam(), 0);
  const ContactSolution<2> there = solved(forth), never_moved = solved(back);
  back.law.previous = tangential_displacement(forth, there);
  const ContactSolution<2> returned = solved(back);
  EXPECT_TRUE(returned.accepted({}));
  EXPECT_LT(std::abs(never_moved.force.row(1).sum()),
            0.05 * std::abs(there.force.row(1).sum()));
  EXPECT_GT(std::abs(returned.force.row(1).sum()),
            0.2 * std::abs(there.force.row(1).sum()));
  // now it drags the other way
  EXPECT_LT(returned.force.row(1).sum() * there.force.row(1).sum(), 0);
}

TEST_P(LoadPath, previous_displacement_shifts_where_a_node_sticks) {
  Problem problem = sheared_block(GetParam(), 0);
  problem.law.previous = everywhere(problem.line, 0.003);
  set_friction(problem, 10);
  const ContactSolution<2> solution = solved(problem);
  EXPECT_TRUE(solution.accepted({}));
  const VectorXd off = tangential_displacement(problem, solution) -
                       problem.law.previous.transpose();
  for (int i = 0; i < problem.line.node_count(); ++i)
    if (solution.state[i] == ContactState::stick &&
        problem.law.multiplier == Multiplier::force) {
      EXPECT_LT(std::abs(off[i]), 1e-15);
    }
  EXPECT_GT(std::count(solution.state.begin(), solution.state.end(),
                       ContactState::stick),
            10);
}

// ---- warm starts ---------------------------------------------------------------------------------------------------------

PlacedNodes placed_nodes(const Problem& problem) {
  return {problem.mesh.vertices(Eigen::all, problem.line.vertex),
          problem.line.normal, nodal_lengths(problem.line)};
}

RC_GTEST_PROP(WarmStart, from_its_own_states_a_solution_is_found_in_one_step,
              ()) {
  const Problem problem = problem_of(*random_case(1));
  const ContactSolution<2> cold = solved(problem);
  ContactSettings settings;
  settings.initial_state = cold.state;
  const ContactSolution<2> warm = solved(problem, settings);
  RC_ASSERT(warm.accepted(settings));
  RC_ASSERT(warm.iterations == 1);
  RC_ASSERT(relative_difference(warm.displacement, cold.displacement) < 1e-11);
}

TEST(WarmStart, states_of_a_coarser_mesh_start_a_finer_one) {
  const Problem coarse = example_1(Multiplier::pressure, 8),
                fine = example_1(Multiplier::pressure, 32);
  const ContactStates states = solved(coarse).state;
  ContactSettings settings;
  for (int node : nearest_nodes(placed_nodes(fine), placed_nodes(coarse)))
    settings.initial_state.push_back(states[node]);
  EXPECT_LT(solved(fine, settings).iterations, solved(fine).iterations);
}

TEST(LoadPath, refuses_a_previous_displacement_that_does_not_fit) {
  Problem problem = example_1(Multiplier::force, 2);
  problem.law.previous = VectorXd::Zero(2);
  EXPECT_TRUE(
      says(refusal([&] { solved(problem); }),
           "previous tangential displacement has 2 values where 5 are needed"));
}

}  // namespace
}  // namespace ffcontact
