// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/surface_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/linear/minimum/nonnegative_least_squares.hpp"
#include "support/pi.hpp"
#include "support/random.hpp"
#include "support/solid_problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Motions of one vertex alone: works are the components of its node's force.
MatrixXd motions_of(const SolidProblem& problem, int node) {
  MatrixXd motions = MatrixXd::Zero(problem.b.size(), 3);
  motions.middleRows<3>(3 * problem.surface.vertex[node]) =
      problem.surface.frame(node);
  return motions;
}

/// How far a force is from those that extreme_forces span.
double distance(const MatrixXd& forces, const Vector3d& force) {
  return (forces * nonnegative_least_squares(forces, force) - force).norm();
}

RC_GTEST_PROP(SurfaceBalance, forces_in_the_cone_are_spanned, ()) {
  const double mu = *real(0.01, 3), angle = *real(-4, 4), part = *real(0, 1);
  SolidProblem problem(brick({1, 1, 1}, {1, 1, 1}), mu);
  const MatrixXd forces =
      extreme_forces(problem.surface, problem.law, motions_of(problem, 2));
  const Vector3d along(0, std::cos(angle), std::sin(angle));
  RC_ASSERT(distance(forces, part * mu * along - Vector3d::UnitX()) < 1e-14);
  RC_ASSERT(distance(forces, 1.003 * mu * along - Vector3d::UnitX()) > 1e-5);
  RC_ASSERT(distance(forces, 0.1 * mu * along + Vector3d::UnitX()) > 0.1);
  for (const auto force : forces.colwise()) RC_ASSERT(force.norm() < 1 + 1e-14);
}

/// Without friction -n alone, with a bound that is given tangents beside it.
TEST(SurfaceBalance, of_other_laws) {
  SolidProblem problem(brick({1, 1, 1}, {1, 1, 1}), 0);
  const MatrixXd motions = motions_of(problem, 1);
  EXPECT_EQ(extreme_forces(problem.surface, problem.law, motions).cols(), 4);
  problem.law.slip_bound = VectorXd::Constant(4, 2);
  const MatrixXd forces = extreme_forces(problem.surface, problem.law, motions);
  EXPECT_LT(distance(forces, {0, 3, -5}), 1e-13);
  EXPECT_LT(distance(forces, {-1, 3, -5}), 1e-13);
  EXPECT_NEAR(distance(forces, {1, 0, 0}), 1, 1e-13);
}

}  // namespace
}  // namespace ffcontact
