// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/pi.hpp"
#include "support/pressed_bricks.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solid_defects.hpp"
#include "support/told.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(SolidContact, fulfils_the_law_and_equilibrium, (Random random)) {
  const SolidProblem problem = random_problem(*real(0, 5), random);
  const ContactSolution<3> solution = problem.solve();
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(defects(problem, solution).largest() < 1e-8);
}

ContactSettings in_single_precision() {
  ContactSettings settings;
  settings.single_precision_from = 0;
  return settings;
}

RC_GTEST_PROP(SolidContact, is_the_same_by_a_factor_in_single_precision,
              (Random random)) {
  const SolidProblem problem = random_problem(*real(0, 2), random);
  const ContactSolution<3> solution = problem.solve(in_single_precision());
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(defects(problem, solution).largest() < 1e-8);
  const ContactSolution<3> other = problem.solve();
  const double size = other.displacement.cwiseAbs().maxCoeff();
  RC_ASSERT((solution.displacement - other.displacement).cwiseAbs().maxCoeff() <
            1e-7 * size);
}

TEST(SolidContact, tells_of_its_factor_and_of_every_step) {
  const SolidProblem problem =
      block_problem(brick({8, 4, 4}, {80, 40, 40}), BlockCase::press, 0.5);
  for (ContactSettings settings : {ContactSettings{}, in_single_precision()}) {
    std::vector<Progress> told;
    settings.report = [&](const Progress& p) { told.push_back(p); };
    const ContactSolution<3> solution = problem.solve(settings);
    ASSERT_TRUE(solution.accepted({}));
    EXPECT_STREQ(told.front().phase, "factorisation");
    EXPECT_EQ(told.front().value, problem.mesh.vertices.size());
    EXPECT_TRUE(counts_columns(of_phase(told, "factorisation, column")));
    const auto schur = of_phase(told, "Schur complement, column");
    EXPECT_TRUE(counts_columns(schur));
    EXPECT_LE(schur.back().value, 3 * problem.surface.node_count());
    const auto newton = of_phase(told, "Newton");
    EXPECT_EQ(static_cast<int>(newton.size()), solution.iterations);
    EXPECT_GT(newton.front().value, newton.back().value);
    EXPECT_LT(newton.back().value, 1e-6);
  }
}

/// Where full steps of Newton cycle, and the fixed point does too.
TEST(SolidContact, shortened_steps_end_cycles) {
  for (unsigned seed : {170647452u, 17624475u, 634230521u}) {
    Random random(seed);
    EXPECT_TRUE(rough_problem(random).solve().accepted({})) << seed;
  }
}

RC_GTEST_PROP(SolidContact, with_gaps_variable_friction_and_a_step_before_too,
              (Random random)) {
  const SolidProblem problem = rough_problem(random);
  const ContactSolution<3> solution = problem.solve();
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(defects(problem, solution).largest() < 1e-8);
}

RC_GTEST_PROP(SolidContact, with_tresca_s_bound_or_a_shear_limit_too,
              (Random random)) {
  SolidProblem problem = random_problem(1, random);
  const int nodes = problem.surface.node_count();
  (*rc::gen::arbitrary<bool>() ? problem.law.slip_bound
                               : problem.law.shear_limit) =
      2 * random_vector(nodes, random).cwiseAbs();
  const ContactSolution<3> solution = problem.solve();
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(defects(problem, solution).largest() < 1e-8);
}

TEST(SolidContact, newton_finds_nodes_at_the_shear_limit) {
  SolidProblem problem =
      block_problem(brick({8, 4, 4}, {80, 40, 40}), BlockCase::press, 0.5);
  const int nodes = problem.surface.node_count();
  problem.law.shear_limit = VectorXd::Constant(nodes, 0.4);
  const ContactSolution<3> solution = problem.solve();
  EXPECT_TRUE(solution.accepted({}) && solution.history.empty());
  EXPECT_LT(defects(problem, solution).largest(), 1e-8);
  int limited = 0, coulomb = 0;
  for (int i = 0; i < nodes; ++i) {
    const Vector3d F = solution.force.col(i);
    const double Ft = F.tail<2>().norm();
    limited += std::abs(Ft - 0.4 * problem.surface.area[i]) < 1e-9 * Ft;
    coulomb += std::abs(Ft + 0.5 * F[0]) < 1e-9 * Ft;
  }
  EXPECT_GT(limited, 0);
  EXPECT_GT(coulomb, 0);
}

/// A wall on a cylinder, cut by two planes of symmetry that its normals are oblique to.
RC_GTEST_PROP(SolidContact, on_a_curve_that_planes_of_symmetry_cut, ()) {
  SolidMesh mesh = brick({6, 3, 1}, {1, 1, 0.2});
  for (auto x : mesh.vertices.colwise()) {
    const double turn = pi / 3 * x.x(), radius = 1 + x.z();
    x = Vector3d(radius * std::sin(turn), x.y(), radius * std::cos(turn));
  }
  SolidProblem problem(mesh, *real(0, 1));
  problem.guide(low_x, 0);
  problem.guide(low_y, 1);
  problem.guide(high_x, 0);  // normals are at 60 degrees to x there
  problem.load(high_z, {0, *real(-1, 1), -5});
  const ContactSolution<3> solution = problem.solve();
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(defects(problem, solution).largest() < 1e-8);
  RC_ASSERT(solution.force.row(0).sum() < 0);
}

class BlockCases : public testing::TestWithParam<BlockCase> {};
INSTANTIATE_TEST_SUITE_P(Loads, BlockCases,
                         testing::Values(BlockCase::press, BlockCase::press_x,
                                         BlockCase::shear, BlockCase::lift));

/// Corrected until rounding in double precision is left; a step of a load path too.
TEST_P(BlockCases, factors_in_single_precision_are_enough) {
  const SolidProblem problem =
      block_problem(brick({8, 4, 4}, {80, 40, 40}), GetParam(), 0.5);
  const ContactSolution<3> exact = problem.solve();
  ContactSettings settings = in_single_precision();
  for (int step = 0; step < 2; ++step) {
    const ContactSolution<3> solution = problem.solve(settings);
    EXPECT_TRUE(solution.accepted({}));
    EXPECT_EQ(solution.stiffness->precision(), Precision::single);
    EXPECT_LT(solution.residual, 1e-11);
    EXPECT_EQ(solution.state, exact.state);
    EXPECT_LT((solution.displacement - exact.displacement).norm(),
              1e-10 * exact.displacement.norm());
    EXPECT_LT((solution.force - exact.force).norm(),
              1e-10 * exact.force.norm());
    settings.stiffness = solution.stiffness;
  }
}

/// Where nothing but contact holds a body, and where single precision leads nowhere: a
/// slender beam that touches nothing.
TEST(SolidContact, factors_in_full_precision_where_single_is_not_enough) {
  SolidProblem free(brick({4, 2, 2}, {4, 2, 2}), 0.5);
  free.load(high_z, {0, 0, -1});
  SolidProblem beam(brick({100, 1, 1}, {100, 1, 1}), 0.5);
  beam.move(low_x, [](const Vector3d&) { return Vector3d(0, 0, 0); });
  beam.load(high_z, {0, 0, -1e-6});
  beam.law.gap = VectorXd::Constant(beam.surface.node_count(), 1e3);
  for (const SolidProblem* problem : {&free, &beam}) {
    ContactSettings settings = in_single_precision();
    settings.initial_state.assign(problem->surface.node_count(),
                                  ContactState::open);
    const ContactSolution<3> solution = problem->solve(settings);
    EXPECT_TRUE(solution.accepted({}));
    EXPECT_EQ(solution.stiffness->precision(), Precision::full);
  }
}

/// The states of a mesh before are a worse guess than what solids find by themselves.
TEST_P(BlockCases, start_by_themselves_on_another_mesh) {
  const SolidProblem problem =
      block_problem(brick({8, 4, 4}, {80, 40, 40}), GetParam(), 0.5);
  ContactSettings settings = in_single_precision();
  const ContactSolution<3> alone = problem.solve(settings);
  settings.initial_state.assign(problem.surface.node_count(),
                                ContactState::open);
  settings.state_of_another_mesh = true;
  const ContactSolution<3> other = problem.solve(settings);
  EXPECT_EQ(other.iterations, alone.iterations);
  EXPECT_EQ(other.displacement, alone.displacement);
}

/// Newton's steps over four loads, straight and moved meshes of two sizes were 1 to 14
/// with friction up to 5.
TEST_P(BlockCases, newton_needs_few_steps) {
  std::mt19937 random(1);
  for (int n : {1, 2})
    for (bool straight : {true, false})
      for (double mu : {0.0, 0.3, 0.5, 1.0, 2.0, 5.0}) {
        const SolidMesh bricks = brick({8 * n, 4 * n, 4 * n}, {80, 40, 40});
        const SolidProblem problem = block_problem(
            straight ? bricks : moved(bricks, 10.0 / n, 0.15, random),
            GetParam(), mu);
        const ContactSolution<3> solution = problem.solve();
        EXPECT_TRUE(solution.accepted({}));
        EXPECT_TRUE(solution.history.empty());
        EXPECT_LE(solution.iterations, 20);
        EXPECT_LT(defects(problem, solution).largest(), 1e-8);
      }
}

/// Whichever method runs out of them
TEST_P(BlockCases, used_up_iterations_are_no_cycle) {
  const SolidProblem problem =
      block_problem(brick({4, 2, 2}, {80, 40, 40}), GetParam(), 0.5);
  for (const ContactSolver solver :
       {ContactSolver::newton, ContactSolver::fixed_point}) {
    ContactSettings settings;
    settings.solver = solver;
    settings.max_iterations = 1;
    const ContactSolution<3> solution = problem.solve(settings);
    EXPECT_EQ(solution.status, ContactStatus::not_converged);
    EXPECT_EQ(solution.iterations, 1);
    EXPECT_GT(solution.complementarity, 1e-6);
  }
}

TEST_P(BlockCases, fixed_point_and_newton_agree) {
  for (double mu : {0.0, 0.3, 1.0}) {
    const SolidProblem problem =
        block_problem(brick({4, 2, 2}, {80, 40, 40}), GetParam(), mu);
    ContactSettings settings;
    settings.solver = ContactSolver::fixed_point;
    const ContactSolution<3> newton = problem.solve(),
                             steps = problem.solve(settings);
    EXPECT_TRUE(steps.accepted(settings));
    EXPECT_FALSE(steps.history.empty());
    EXPECT_LT((newton.force - steps.force).norm(), 1e-8 * newton.force.norm());
  }
}

TEST_P(BlockCases, no_friction_is_tresca_s_law_with_the_bound_0) {
  SolidProblem problem =
      block_problem(brick({4, 2, 2}, {80, 40, 40}), GetParam(), 0);
  const ContactSolution<3> coulomb = problem.solve();
  problem.law.slip_bound = VectorXd::Zero(problem.surface.node_count());
  const ContactSolution<3> tresca = problem.solve();
  EXPECT_EQ(coulomb.displacement, tresca.displacement);
  EXPECT_EQ(coulomb.force, tresca.force);
  EXPECT_TRUE(coulomb.force.bottomRows<2>().isZero(0));
}

RC_GTEST_PROP(SolidContact, does_not_depend_on_numbers_and_units,
              (Random random)) {
  const SolidMesh mesh =
      moved(brick({4, 2, 2}, {80, 40, 40}), 20, 0.15, random);
  const auto loads = *rc::gen::element(BlockCase::press, BlockCase::press_x,
                                       BlockCase::shear, BlockCase::lift);
  const double mu = *real(0, 2);
  const SolidProblem problem = block_problem(mesh, loads, mu);
  const ContactSolution<3> solution = problem.solve();
  const Vector3d force = solution.force.rowwise().sum();
  const ContactSolution<3> other =
      block_problem(shuffled(mesh, random), loads, mu).solve();
  RC_ASSERT((other.force.rowwise().sum() - force).norm() < 1e-9 * force.norm());

  const double unit = std::pow(10, *rc::gen::inRange(-9, 10));
  SolidProblem scaled = problem;
  scaled.A *= unit;
  for (Index dof = 0; dof < scaled.b.size(); ++dof) scaled.b[dof] *= unit;
  const ContactSolution<3> in_units = scaled.solve();
  RC_ASSERT((in_units.force - unit * solution.force).norm() <
            1e-9 * unit * solution.force.norm());
}

/// The body, its foundation and loads turned in space.
RC_GTEST_PROP(SolidContact, does_not_depend_on_the_direction_in_space,
              (Random random)) {
  const SolidMesh mesh =
      moved(brick({4, 2, 2}, {80, 40, 40}), 20, 0.15, random);
  const Matrix3d Q =
      Eigen::Quaterniond(Vector4d(random_vector(4, random).normalized()))
          .toRotationMatrix();
  const auto solve = [&](const Matrix3d& turn) {
    SolidMesh turned = mesh;
    turned.vertices = turn * mesh.vertices;
    SolidProblem problem(turned, 0.4);
    problem.move(high_z, [&](const Vector3d& x) {
      const Vector3d at = turn.transpose() * x;
      return Vector3d(turn * Vector3d(0.02, 0.01, -0.03 + 5e-4 * at.x()));
    });
    const ContactSolution<3> solution = problem.solve();
    Matrix3Xd forces(3, problem.surface.node_count());
    for (int i = 0; i < forces.cols(); ++i)
      forces.col(i) =
          turn.transpose() * problem.surface.frame(i) * solution.force.col(i);
    return forces;
  };
  const Matrix3Xd forces = solve(Matrix3d::Identity());
  RC_ASSERT((solve(Q) - forces).norm() < 1e-9 * forces.norm());
}

RC_GTEST_PROP(SolidContact, a_uniform_pressure_passes_exactly,
              (Random random)) {
  SolidProblem problem(irregular_solid(random), *real(0, 1));
  problem.load(high_z, {0, 0, -10});
  problem.guide(low_x, 0);
  problem.guide(low_y, 1);
  const ContactSolution<3> solution = problem.solve();
  RC_ASSERT(solution.accepted({}));
  if (problem.law.friction[0] > 0) return;  // its lateral strain would slide
  for (int i = 0; i < problem.surface.node_count(); ++i)
    RC_ASSERT(std::abs(solution.force(0, i) + 10 * problem.surface.area[i]) <
              1e-9 * problem.surface.area[i]);
}

/// u = (g z, 0, -e z) with G g = mu (lambda + 2 G) e slips everywhere under a uniform
/// pressure (lambda + 2 G) e.
RC_GTEST_PROP(SolidContact, homogeneous_slip_is_exact, (Random random)) {
  const double mu = 0.5, lambda = 13e3 * 0.2 / 0.72, G = 13e3 / 2.4, e = 1e-3,
               g = mu * (lambda + 2 * G) * e / G;
  SolidProblem problem(irregular_solid(random), mu);
  const SolidField exact = [=](const Vector3d& x) {
    return Vector3d(0.1 + g * x.z(), 0, -e * x.z());
  };
  for (int side : {high_z, low_x, high_x, low_y, high_y})
    for (int v : vertices_on(problem.mesh, side)) {
      const Vector3d x = problem.mesh.vertices.col(v);
      if (x.z() == 0) continue;
      for (int c = 0; c < 3; ++c) problem.prescribe(v, c, exact(x)[c]);
    }
  // the faces of those sides at the bottom edge have free dofs and tractions
  const Matrix3d sigma = (Matrix3d() << -lambda * e, 0, G * g, 0, -lambda * e,
                          0, G * g, 0, -(lambda + 2 * G) * e)
                             .finished();
  for (int side : {low_x, high_x, low_y, high_y}) {
    Vector3d n = Vector3d::Zero();
    n[(side - 1) / 2] = side % 2 == 1 ? -1 : 1;
    SolidProblem loaded = problem;
    loaded.load(side, sigma * n);
    for (Index dof = 0; dof < problem.b.size(); ++dof)
      if (problem.A.coeff(dof, dof) < 1e20) problem.b[dof] = loaded.b[dof];
  }
  const ContactSolution<3> solution = problem.solve();
  RC_ASSERT(solution.accepted({}));
  const VectorXd expected = nodal_values(problem.mesh, exact);
  RC_ASSERT((solution.displacement - expected).norm() < 1e-9 * expected.norm());
}

/// Dragged by its top, friction opposes slip at every node.
TEST(SolidContact, friction_opposes_slip_in_any_direction) {
  for (double angle : {0.0, 0.3, 1.0, 2.0, 4.0}) {
    SolidProblem problem(brick({3, 3, 2}, {3, 3, 2}), 0.3);
    const Vector3d drag(0.1 * std::cos(angle), 0.1 * std::sin(angle), -1e-3);
    problem.move(high_z, [&](const Vector3d&) { return drag; });
    const ContactSolution<3> solution = problem.solve();
    ASSERT_TRUE(solution.accepted({}));
    for (int i = 0; i < problem.surface.node_count(); ++i) {
      const Vector3d F = solution.force.col(i);
      EXPECT_NEAR(F.tail<2>().norm(), -0.3 * F[0], 1e-12 * F.norm());
    }
    const Vector3d sum = solution.force.rowwise().sum();
    EXPECT_NEAR(std::remainder(std::atan2(-sum[2], -sum[1]) - angle, 2 * pi), 0,
                0.02);
  }
}

/// A circular cone: a pyramid would hold up to 1.41 mu N in some direction.
TEST(SolidContact, a_block_slides_at_mu_N_in_every_direction) {
  for (double angle : {0.0, 0.3, pi / 4, 1.2, 3.0, 5.5}) {
    const Vector3d lateral(std::cos(angle), std::sin(angle), 0);
    const auto loaded = [&](double share) {
      SolidProblem problem(brick({4, 4, 1}, {8, 8, 2}), 0.3);
      problem.load(high_z, {0, 0, -10});
      // at the height of the plane, so that it does not tilt: a body load would
      for (int i = 0; i < problem.surface.node_count(); ++i)
        problem.b.segment<3>(3 * problem.surface.vertex[i]) +=
            share * 0.3 * 10 * problem.surface.area[i] * lateral;
      return problem;
    };
    const ContactSolution<3> held = loaded(0.99).solve();
    EXPECT_TRUE(held.accepted({})) << angle;
    EXPECT_NE(refusal([&] { loaded(1.01).solve(); }).find("no equilibrium"),
              std::string::npos)
        << angle;
  }
}

TEST(SolidContact, prescribed_penetration_is_refused_with_its_place) {
  SolidProblem problem(brick({2, 2, 2}, {1, 1, 1}), 0.3);
  problem.move(high_z, [](const Vector3d&) { return Vector3d::Zero(); });
  for (int c = 0; c < 3; ++c) problem.prescribe(4, c, c == 2 ? -0.1 : 0);
  EXPECT_NE(refusal([&] { problem.solve(); }).find("vertex 4 (0.5, 0.5, 0)"),
            std::string::npos)
      << refusal([&] { problem.solve(); });
}

/// In a corner of three planes, pressed into it.
RC_GTEST_PROP(SolidContact, in_a_corner_of_three_planes, (Random random)) {
  SolidProblem problem(irregular_solid(random), *real(0, 0.4),
                       {low_x, low_y, low_z});
  problem.load(high_z, {0, 0, -3});
  problem.load(high_x, {-2, 0, 0});
  problem.load(high_y, {0, -1, 0});
  const ContactSolution<3> solution = problem.solve();
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(defects(problem, solution).largest() < 1e-8);
}

}  // namespace
}  // namespace ffcontact
