// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/contact/multigrid_relation.hpp"
#include "ffcontact/contact/residual_defect.hpp"
#include "support/by_multigrid.hpp"
#include "support/pressed_bricks.hpp"
#include "support/threads.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Beside the compliance of the blocks' cells, 1e-3 mm/MPa: nothing, little, as much, and so
/// much that nothing else is.
constexpr double compliances[] = {1e-12, 1e-6, 1e-3, 1e-1, 10};

SolidProblem block_on_layer(BlockCase loads, double mu,
                            const CompliantLayer& layer) {
  SolidProblem problem =
      block_problem(brick({8, 4, 4}, {80, 40, 40}), loads, mu);
  problem.law.layer = layer;
  return problem;
}

TEST(MultigridLayer, has_the_answer_of_a_factor) {
  for (const BlockCase loads : {BlockCase::press, BlockCase::press_x,
                                BlockCase::shear, BlockCase::lift})
    for (const double mu : {0.0, 0.5, 2.0})
      for (const double c : compliances)
        for (const CompliantLayer& layer :
             {CompliantLayer{c, 0}, CompliantLayer{0, c},
              CompliantLayer{c, 3 * c}})
          expect_same(block_on_layer(loads, mu, layer));
}

TEST(MultigridLayer,
     has_it_of_a_load_step_with_gaps_along_directions_that_turn) {
  Random random(1);
  for (const double c : compliances) {
    SolidProblem problem = block_on_layer(BlockCase::press, 0.5, {c, 2 * c});
    problem.surface = turned_at_random(problem.surface, 0.2, random);
    const int nodes = problem.surface.node_count();
    problem.law.previous = 1e-2 * random_matrix(2, nodes, random);
    problem.law.gap = 1e-3 * random_vector(nodes, random).cwiseAbs();
    expect_same(problem);
  }
}

TEST(MultigridLayer, has_it_of_a_body_that_contact_alone_holds) {
  for (const double c : {1e-12, 1e-6, 1e-3, 1.0}) {
    SolidProblem problem(brick({8, 4, 4}, {80, 40, 40}), 0.5);
    problem.load(high_z, {0.5, 0.2, -5});
    problem.law.layer = {c, 2 * c};
    expect_same(problem);
  }
}

TEST(MultigridLayer, has_it_of_solids_whose_meshes_do_not_match) {
  for (const double stiffness : {1e-3, 1.0, 10.0})
    for (const double mu : {0.0, 0.3, 1.0})
      for (const double c : {1e-9, 1e-5, 1e-3}) {
        SolidStack stack = block_on_a_block(mu, stiffness);
        stack.problem.law.layer = {c, 0.5 * c};
        expect_same(stack.problem);
      }
}

TEST(MultigridLayer, starts_from_rows_that_are_near) {
  for (const double c : {1e-6, 1e-3, 1.0}) {
    const ColdAndWarm found(block_on_layer(BlockCase::lift, 0.5, {c, 2 * c}));
    EXPECT_LE(found.warm.iterations, found.cold.iterations);
  }
}

/// What it would be without a layer, in as many systems.
TEST(MultigridLayer, needs_few_systems_if_it_is_stiff) {
  SolidProblem problem =
      block_problem(brick({24, 12, 12}, {80, 40, 40}), BlockCase::lift, 0.5);
  const ContactSolution<3> without = problem.solve(by(LinearSolver::multigrid));
  for (const double c : {1e-300, 1e-12, 1e-9}) {
    problem.law.layer = {c, 2 * c};
    const ContactSolution<3> found = problem.solve(by(LinearSolver::multigrid));
    EXPECT_EQ(found.multigrid, Multigrid::used);
    EXPECT_LE(found.iterations, without.iterations + 2);
    EXPECT_LE(max_norm(found.force - without.force),
              1e-5 * max_norm(without.force));
  }
}

/// Forces of loads that a soft layer hardly carries, and their rounding, do not keep Newton
/// from its states.
TEST(MultigridLayer, needs_few_systems_if_it_is_soft) {
  const SolidMesh mesh = brick({24, 12, 12}, {80, 40, 40});
  for (const double c : {1.0, 100.0, 1e4}) {
    SolidProblem problem = block_problem(mesh, BlockCase::press_x, 0.5);
    problem.law.layer = {c, 2 * c};
    const ContactSolution<3> found = problem.solve(by(LinearSolver::multigrid));
    EXPECT_TRUE(found.accepted({}));
    EXPECT_EQ(found.multigrid, Multigrid::used);
    EXPECT_LE(found.iterations, 6);
  }
}

/// With P on the layer already.
TEST(MultigridLayer, corrects_a_displacement_that_is_off) {
  Random random(1);
  for (const double c : compliances) {
    const SolidProblem problem =
        block_on_layer(BlockCase::press_x, 0.5, {c, 2 * c});
    const ElasticSystem system = problem.system();
    const SurfaceTrace trace =
        surface_trace(problem.surface, problem.law, system);
    const ContactSettings settings = by(LinearSolver::multigrid);
    const StatedSurface stated{problem.surface, problem.law, system, settings,
                               trace};
    const auto relation = multigrid_relation(problem.mesh.vertices, stated);
    const RelationAnswer first = relation->answer();
    const ActiveSetResult& found = first.law.answer;
    const Index nodes = problem.surface.node_count();
    const VectorXd force = found.P.head(3 * nodes),
                   u = system.prescribed_value + first.displacement,
                   off = on_free_dofs(
                       system, 1e-2 * max_norm(u) *
                                   random_vector(system.dof_count(), random)),
                   none = VectorXd::Zero(system.dof_count());
    const RelationAnswer second =
        relation->corrected({found, force_residual(system, u + off, none),
                             stated.v_of(u + off, force)},
                            {60, 1e-10});
    const ActiveSetResult& corrected = second.law.answer;
    EXPECT_EQ(corrected.status, ContactStatus::converged);
    EXPECT_LE(max_norm(off + second.displacement), 1e-8 * max_norm(u));
    EXPECT_LE(max_norm(corrected.P.head(3 * nodes) - force),
              1e-7 * max_norm(force));
  }
}

/// A bar between smooth walls is a spring in series with its layer.
TEST(MultigridLayer, is_in_series_with_a_bar) {
  const double stiff = 13e3 * 0.2 / 0.72 + 2 * 13e3 / 2.4, length = 3, d = 1e-2,
               gap = 2e-3;
  for (const double c : {1e-9, 1e-5, 1e-4, 1e-2}) {
    SolidProblem problem(brick({3, 2, 4}, {2, 1, length}), 0.5);
    for (const int side : {low_x, high_x}) problem.guide(side, 0);
    for (const int side : {low_y, high_y}) problem.guide(side, 1);
    problem.move(high_z, [=](const Vector3d&) { return Vector3d(0, 0, -d); });
    problem.law.gap = VectorXd::Constant(problem.surface.node_count(), gap);
    problem.law.layer = {c, 0};
    const ContactSolution<3> found = problem.solve(by(LinearSolver::multigrid));
    ASSERT_TRUE(found.accepted({}));
    EXPECT_EQ(found.multigrid, Multigrid::used);
    const double pressure = (d - gap) / (length / stiff + c);
    EXPECT_LE(max_norm(lumped_pressures(problem.surface, found.force).row(0) +
                       Matrix<double, 1, Dynamic>::Constant(
                           problem.surface.node_count(), pressure)),
              1e-9 * pressure);
  }
}

TEST(MultigridLayer, has_the_same_digits_on_two_threads) {
  const SolidProblem problem =
      block_on_layer(BlockCase::press_x, 0.5, {1e-4, 2e-4});
  const auto answer = [&] {
    return problem.solve(by(LinearSolver::multigrid)).displacement;
  };
  EXPECT_EQ(on_threads(1, answer), on_threads(2, answer));
}

CompliantLayer random_compliance(Random& random) {
  const auto drawn = [&] {
    return random() % 4 == 0 ? 0 : std::pow(10, Uniform{-9, 0}(random));
  };
  const double normal = drawn();
  return {normal, drawn()};
}

RC_GTEST_PROP(MultigridLayer, has_the_answer_of_a_factor_of_random_solids,
              (Random random)) {
  SolidProblem problem = random_solids(0.3, random).problem;
  problem.law.layer = random_compliance(random);
  const ContactSolution<3> other = problem.solve(by(LinearSolver::direct));
  RC_PRE(other.accepted({}));
  const ContactSolution<3> one = problem.solve([] {
    ContactSettings from_0;
    from_0.multigrid_from = 0;
    from_0.tolerance = 1e-11;  // forces may be small beside the loads
    return from_0;
  }());
  RC_TAG(one.multigrid == Multigrid::used);
  RC_ASSERT(one.accepted({}));
  RC_ASSERT(max_norm(one.force - other.force) <= 1e-7 * max_norm(other.force));
}

RC_GTEST_PROP(MultigridLayer, has_the_answer_of_a_factor_of_rough_problems,
              (Random random)) {
  SolidProblem problem = rough_problem(random);
  problem.law.friction *= 0.3;  // one solution
  problem.law.layer = random_compliance(random);
  const ContactSolution<3> one = problem.solve(by(LinearSolver::multigrid)),
                           other = problem.solve(by(LinearSolver::direct));
  RC_TAG(one.multigrid == Multigrid::used);
  RC_ASSERT(one.accepted({}));
  RC_ASSERT(other.accepted({}));
  RC_ASSERT(max_norm(one.force - other.force) <= 1e-7 * max_norm(other.force));
}

}  // namespace
}  // namespace ffcontact
