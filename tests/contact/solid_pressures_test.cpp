// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"
#include "support/solid_bodies.hpp"
#include "support/solid_defects.hpp"

/// Multipliers that are pressures, linear on each face (M'_h in three dimensions).
namespace ffcontact {
namespace {

using namespace test;

/// For bodies on the plane z = 0, whose rows n, t1, t2 are the dofs z, x, y.
int dof_of_row(const SolidProblem& problem, int node, int c) {
  return 3 * problem.surface.vertex[node] + (c == 0 ? 2 : c - 1);
}

/// int phi_i w over the faces, w linear on each: what the law says of displacements, and
/// what pressures do to the body.
Matrix3Xd weighted(const SolidProblem& problem, const Matrix3Xd& nodal) {
  Matrix3Xd sum = Matrix3Xd::Zero(3, nodal.cols());
  for (int m = 0; m < problem.surface.face_count(); ++m) {
    const double area =
        facet_measure(problem.mesh, problem.faces, problem.surface.face[m]);
    for (int i : problem.surface.face_node.col(m))
      for (int j : problem.surface.face_node.col(m))
        sum.col(i) += area / (i == j ? 6 : 12) * nodal.col(j);
  }
  return sum;
}

/// Rows without the prescribed ones.
Matrix3Xd free_rows(const SolidProblem& problem, Matrix3Xd rows) {
  const ElasticSystem system = problem.system();
  for (int i = 0; i < rows.cols(); ++i)
    for (int c = 0; c < 3; ++c)
      if (system.prescribed[dof_of_row(problem, i, c)]) rows(c, i) = 0;
  return rows;
}

/// The law between P and M v, relative.
double law_defect(const SolidProblem& problem,
                  const SurfaceSolution& solution) {
  const ElasticSystem system = problem.system();
  Matrix3Xd v = free_rows(
      problem, displacement_against_foundation(problem.surface, problem.law,
                                               solution.displacement));
  v = weighted(problem, v) /
      (solution.displacement.norm() * problem.surface.area.maxCoeff());
  const Matrix3Xd P = solution.pressure / solution.pressure.norm();
  double largest = 0;
  for (int i = 0; i < v.cols(); ++i) {
    const double bound = -problem.law.friction[i] * P(0, i);
    largest = std::max({largest, P(0, i), P.col(i).tail<2>().norm() - bound});
    bool is_free = true;
    for (int c = 0; c < 3; ++c)
      is_free = is_free && !system.prescribed[dof_of_row(problem, i, c)];
    if (!is_free) continue;
    const Vector2d slip = v.col(i).tail<2>();
    const double missed =
        (P.col(i).tail<2>() + bound * slip.stableNormalized()).norm();
    largest = std::max({largest, v(0, i), std::min(-P(0, i), -v(0, i)),
                        std::min(slip.norm(), missed)});
  }
  return largest;
}

SolidProblem random_pressed(double mu, Random& random) {
  SolidProblem problem =
      block_problem(moved(brick({4, 2, 2}, {80, 40, 40}), 20, 0.15, random),
                    static_cast<BlockCase>(random() % 4), mu);
  problem.law.multiplier = Multiplier::pressure;
  return problem;
}

RC_GTEST_PROP(SolidPressures, fulfil_the_law_and_equilibrium, (Random random)) {
  const SolidProblem problem = random_pressed(*real(0, 2), random);
  const SurfaceSolution solution = problem.solve();
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(law_defect(problem, solution) < 1e-8);
  RC_ASSERT(defects(problem, solution).balance < 1e-9);
  const Matrix3Xd load =
      free_rows(problem, weighted(problem, solution.pressure));
  RC_ASSERT((solution.force - load).norm() < 1e-10 * load.norm());
}

RC_GTEST_PROP(SolidPressures, newton_and_the_fixed_point_agree,
              (Random random)) {
  const SolidProblem problem = random_pressed(*real(0, 0.5), random);
  ContactSettings settings;
  settings.solver = ContactSolver::fixed_point;
  const SurfaceSolution newton = problem.solve(),
                        steps = problem.solve(settings);
  RC_ASSERT(steps.accepted(settings));
  RC_ASSERT((newton.displacement - steps.displacement).norm() <
            1e-7 * newton.displacement.norm());
}

RC_GTEST_PROP(SolidPressures, are_uniform_through_a_stack, (Random random)) {
  SolidStack stack({random_brick({3, 2, 1}, {0, 0, 0}, {3, 2, 1}, random),
                    random_brick({2, 3, 2}, {0, 0, -1}, {3, 2, 1}, random),
                    random_brick({7, 5, 1}, {0, 0, -2}, {3, 2, 1}, random)},
                   *real(0, 1));
  SolidProblem& problem = stack.problem;
  problem.law.multiplier = Multiplier::pressure;
  for (int k = 0; k <= stack.last(); ++k) stack.guide(k);
  problem.guide(stack.label(2, low_z), 2);
  problem.load(stack.label(0, high_z), {0, 0, -10});
  const SurfaceSolution solution = problem.solve();
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT((solution.pressure.row(0).array() + 10).abs().maxCoeff() < 1e-9);
}

/// A bound that is stated as a traction is one of pressures.
TEST(SolidPressures, tresca_s_bound_is_a_pressure) {
  SolidProblem problem =
      block_problem(brick({8, 4, 4}, {80, 40, 40}), BlockCase::shear, 0);
  problem.law.multiplier = Multiplier::pressure;
  problem.law.slip_bound =
      VectorXd::Constant(problem.surface.node_count(), 0.5);
  const SurfaceSolution solution = problem.solve();
  EXPECT_TRUE(solution.accepted({}));
  EXPECT_NEAR(solution.pressure.bottomRows<2>().colwise().norm().maxCoeff(),
              0.5, 1e-9);
}

}  // namespace
}  // namespace ffcontact
