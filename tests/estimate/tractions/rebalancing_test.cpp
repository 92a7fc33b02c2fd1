// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/rebalancing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "ffcontact/elastic/multigrid/multigrid_inverse.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "support/cases.hpp"
#include "support/solid_problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Random forces on the contact vertices that do no work on the motions.
VectorXd balanced_forces(const Problem& problem, const MatrixXd& motions,
                         Random& random) {
  VectorXd forces = VectorXd::Zero(problem.b.size());
  MatrixXd on_line = MatrixXd::Zero(motions.rows(), motions.cols());
  for (int v : problem.line.vertex) {
    forces.segment<2>(2 * v) = random_vector(2, random);
    on_line.middleRows(2 * v, 2) = motions.middleRows(2 * v, 2);
  }
  if (motions.cols() > 0)
    forces -= on_line * (on_line.transpose() * on_line).inverse() *
              (motions.transpose() * forces);
  return forces;
}

RC_GTEST_PROP(Rebalancing, balances_the_change_of_forces, (Random random)) {
  const Problem problem = problem_of(*random_case(0.5));
  const ElasticSystem system = problem.system();
  const MatrixXd motions = free_rigid_motions(problem.mesh, system.prescribed);
  const VectorXd forces = balanced_forces(problem, motions, random);
  const VectorXd u =
      Rebalancing(system, contact_dofs(problem.line, system), motions)
          .displacement(forces);
  const VectorXd residual = system.stiffness * u - forces;
  for (int dof = 0; dof < system.dof_count(); ++dof)
    RC_ASSERT((system.prescribed[dof] ? std::abs(u[dof])
                                      : std::abs(residual[dof])) < 1e-9);
}

std::vector<int> contact_dofs_of(const SolidProblem& problem,
                                 const ElasticSystem& system) {
  const VectorXi& vertex = problem.surface.vertex;
  return free_dofs_at({vertex.begin(), vertex.end()}, system);
}

/// The residuals of K correct it.
RC_GTEST_PROP(Rebalancing, by_a_factor_in_single_precision_is_as_good,
              (Random random)) {
  SolidProblem problem(brick({4, 3, 2}, {4, 3, 2}), 0.5);
  problem.move(high_z, [](const Vector3d&) { return Vector3d(0, 0, -1e-3); });
  const ElasticSystem system = problem.system();
  const std::vector<int> kept = contact_dofs_of(problem, system);
  const MatrixXd no_motions(system.dof_count(), 0);
  VectorXd forces = random_vector(system.dof_count(), random);
  for (int dof = 0; dof < forces.size(); ++dof)
    if (system.prescribed[dof]) forces[dof] = 0;
  const VectorXd u = Rebalancing(system, kept, no_motions,
                                 std::make_shared<const CondensedStiffness>(
                                     system, kept, Precision::single))
                         .displacement(forces);
  const VectorXd residual = system.stiffness * u - forces;
  for (int dof = 0; dof < system.dof_count(); ++dof)
    RC_ASSERT((system.prescribed[dof] ? std::abs(u[dof])
                                      : std::abs(residual[dof])) < 1e-12);
}

/// A slender beam, whose residuals no factor in single precision lowers.
TEST(Rebalancing, factors_in_full_precision_where_single_is_not_enough) {
  SolidProblem problem(brick({100, 1, 1}, {100, 1, 1}), 0.5);
  problem.move(low_x, [](const Vector3d&) { return Vector3d(0, 0, 0); });
  const ElasticSystem system = problem.system();
  const std::vector<int> kept = contact_dofs_of(problem, system);
  const MatrixXd no_motions(system.dof_count(), 0);
  VectorXd forces = VectorXd::Zero(system.dof_count());
  for (int v = 0; v < problem.mesh.vertex_count(); ++v)
    if (problem.mesh.place(v).x() == 100) forces[3 * v + 2] = 1;
  const auto single = std::make_shared<const CondensedStiffness>(
      system, kept, Precision::single);
  const VectorXd u =
      Rebalancing(system, kept, no_motions, single).displacement(forces);
  const VectorXd exact =
      Rebalancing(system, kept, no_motions).displacement(forces);
  EXPECT_EQ(single->precision(), Precision::single);
  EXPECT_LT((u - exact).norm(), 1e-12 * exact.norm());
}

/// Of a body that is held, and of one that contact alone holds.
TEST(Rebalancing, by_multigrid_is_that_of_a_factor) {
  for (const bool held : {true, false}) {
    SolidProblem problem(brick({8, 6, 4}, {8, 6, 4}), 0.5);
    if (held)
      problem.move(high_z, [](const Vector3d&) { return Vector3d(0, 0, 0); });
    const ElasticSystem system = problem.system();
    const std::vector<int> kept = contact_dofs_of(problem, system);
    const MatrixXd motions =
        free_rigid_motions(problem.mesh, system.prescribed);
    ASSERT_EQ(motions.cols(), held ? 0 : 6);
    const VectorXd some = VectorXd::NullaryExpr(
        system.dof_count(), [](Index k) { return std::sin(k * k); });
    const VectorXd forces =
        on_free_dofs(system, system.stiffness * on_free_dofs(system, some));
    const VectorXd exact =
        Rebalancing(system, kept, motions).displacement(forces);
    const VectorXd u =
        Rebalancing(system, kept, motions,
                    multigrid_inverse(system, problem.mesh.vertices))
            .displacement(forces);
    EXPECT_LT((u - exact).norm(), 1e-11 * exact.norm());
    EXPECT_LT(on_free_dofs(system, system.stiffness * u - forces).norm(),
              1e-11 * forces.norm());
  }
}

/// What gives nothing near is not taken.
TEST(Rebalancing, factors_where_an_inverse_leads_nowhere) {
  SolidProblem problem(brick({4, 3, 2}, {4, 3, 2}), 0.5);
  problem.move(high_z, [](const Vector3d&) { return Vector3d(0, 0, 0); });
  const ElasticSystem system = problem.system();
  const std::vector<int> kept = contact_dofs_of(problem, system);
  const VectorXd forces =
      on_free_dofs(system, VectorXd::Ones(system.dof_count()));
  const VectorXd u =
      Rebalancing(system, kept, MatrixXd(system.dof_count(), 0),
                  [](const VectorXd& f) -> VectorXd { return 0 * f; })
          .displacement(forces);
  EXPECT_LT(on_free_dofs(system, system.stiffness * u - forces).norm(),
            1e-11 * forces.norm());
}

}  // namespace
}  // namespace ffcontact
