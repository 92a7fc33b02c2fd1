// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/bounds_by_turns.hpp"

#include <gtest/gtest.h>

#include "ffcontact/bounds/coulomb_on_line.hpp"
#include "support/bounded.hpp"
#include "support/bounded_solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A turn takes a contact problem for v and one for tau, and the first v one more; all have
/// the factor of what was solved.
template <int d>
void expect_one_factor(const BoundedQuantity<d>& bounded) {
  BoundsByTurns<d> turns(bounded, {});
  const RelaxationSettings relaxation{1};
  const double s = 1e-2 * bounded.stress / bounded.load.norm();
  OneBound<d> bound = turns.bound(s, 3, relaxation);
  EXPECT_EQ(turns.cost().contact_problems, 7);
  EXPECT_EQ(turns.cost().estimates, 3);
  bound = turns.after_a_turn(bound, relaxation);
  EXPECT_EQ(turns.cost().contact_problems, 9);
  EXPECT_EQ(turns.cost().estimates, 4);
  ASSERT_NE(turns.factor(), nullptr);
  EXPECT_EQ(turns.factor(), bounded.solved.body.stiffness.get());
}

TEST(BoundsByTurns, of_plane_bodies_have_one_factor) {
  Problem problem = example_1(Multiplier::force, 4);
  set_friction(problem, 0);
  problem.law.slip_bound = everywhere(problem.line, 2);
  const Solved solved(problem);
  const SolvedProblem<2> as_problem = solved.as_problem();
  const Estimate<2> first = solved.estimate();
  expect_one_factor(bounded_quantity(
      as_problem, first, on_label<2>(problem.mesh, left, {1.0 / 40, 0})));
}

/// v is sought with twice as many nodes.
TEST(BoundsByTurns, with_coulombs_law_have_one_factor) {
  const Problem problem = example_1(Multiplier::force, 4);
  const Solved solved(problem);
  const Estimate<2> first = solved.estimate();
  SolvedBody<2> known = solved.body;
  known.law = with_bound_of(known.law, problem.line, first.tractions);
  const SolvedProblem<2> as_problem{solved.topology, problem.line,
                                    solved.system, known};
  const BoundedQuantity<2> tresca = bounded_quantity(
      as_problem, first, on_label<2>(problem.mesh, left, {1.0 / 40, 0}));
  expect_one_factor(with_coulombs_law(tresca, problem.law, 0.5));
}

TEST(BoundsByTurns, of_solids_have_one_factor) {
  SolidProblem problem =
      block_problem(brick({4, 2, 2}, {80, 40, 40}), BlockCase::press, 0);
  problem.law.slip_bound = on_all_nodes(problem, 2);
  const SolidWithAnswer solved(problem);
  const SolvedProblem<3> as_problem = solved.as_problem();
  const Estimate<3> first = estimate_error<3>(solved.topology, problem.surface,
                                              solved.system, solved.body);
  expect_one_factor(
      bounded_quantity(as_problem, first,
                       on_label<3>(problem.mesh, high_x, {1.0 / 1600, 0, 0})));
}

}  // namespace
}  // namespace ffcontact
