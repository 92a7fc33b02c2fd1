// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"

#include <gtest/gtest.h>

#include "ffcontact/elastic/stiffness.hpp"
#include "support/cases.hpp"
#include "support/estimates.hpp"
#include "support/loaded_solid.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

NodalResidual<2> residual_of(const Problem& problem,
                             const VectorXd& displacement) {
  const Matrix2Xd zero = Matrix2Xd::Zero(2, problem.line.edge_count());
  const BoundaryTractions given = boundary_tractions(
      problem.mesh, problem.edges, prescribed_dofs(problem.A), problem.neumann,
      problem.line, {zero, zero});
  return nodal_residual(topology_of(problem.mesh),
                        stresses(problem.mesh, problem.hooke, displacement),
                        body_loads(problem), given);
}

/// b - K u, row by row, where no support answers.
RC_GTEST_PROP(NodalResidual, is_what_the_loads_lack_in_the_linear_system,
              (Random random)) {
  Problem problem = problem_of(*random_case(0.5));
  add_body_force(problem, random_vector(2, random));
  const ElasticSystem system = problem.system();
  const VectorXd u = random_vector(problem.b.size(), random);
  const VectorXd K_u = stiffness(problem.mesh, problem.hooke) * u;
  const NodalResidual<2> residual = residual_of(problem, u);
  int free = 0;
  for (int dof = 0; dof < u.size(); ++dof) {
    if (residual.supported(dof % 2, dof / 2)) {
      RC_ASSERT(system.prescribed[dof] &&
                residual.missing(dof % 2, dof / 2) == 0);
    } else if (!system.prescribed[dof]) {
      ++free;
      RC_ASSERT(std::abs(residual.missing(dof % 2, dof / 2) - problem.b[dof] +
                         K_u[dof]) <= 1e-12 * K_u.cwiseAbs().maxCoeff());
    }
  }
  RC_ASSERT(free > 0);
}

TEST(NodalResidual, takes_forces_where_no_support_answers) {
  const Problem problem = example_1(Multiplier::force, 2);
  const VectorXd u = VectorXd::Zero(problem.b.size());
  const NodalResidual<2> before = residual_of(problem, u);
  const NodalResidual<2> after =
      with_forces(before, VectorXd::Constant(problem.b.size(), 1e3));
  ASSERT_TRUE(before.supported.any());
  for (Index v = 0; v < before.missing.cols(); ++v)
    for (int c = 0; c < 2; ++c)
      EXPECT_EQ(after.missing(c, v) - before.missing(c, v),
                before.supported(c, v) ? 0 : 1e3);
  EXPECT_EQ(after.scale, 1e3);
}

TEST(NodalResidual,
     refuses_loads_that_u_was_not_computed_with_naming_the_vertex) {
  Problem problem = example_1(Multiplier::force, 2);
  const ContactSolution<2> solution = solved(problem);
  problem.neumann *= 1.01;
  const std::string sentence =
      refusal([&] { equilibrated(problem, solution); });
  EXPECT_TRUE(says(sentence,
                   "the loads do not balance the stresses at vertex 5 (0, 20): "
                   "2 N/mm are left over"))
      << sentence;
}

TEST(NodalResidual, refuses_a_body_force_that_u_was_not_computed_with) {
  Problem problem = example_1(Multiplier::force, 2);
  const ContactSolution<2> solution = solved(problem);
  problem.body_force.array() += 0.01;
  EXPECT_TRUE(says(refusal([&] { equilibrated(problem, solution); }),
                   "the loads do not balance the stresses at vertex "));
}

TEST(NodalResidual, refuses_contact_tractions_of_another_solution) {
  const Problem problem = example_1(Multiplier::force, 2);
  ContactSolution<2> solution = solved(problem);
  solution.pressure *= 1.1;
  EXPECT_TRUE(says(refusal([&] { equilibrated(problem, solution); }),
                   "the loads do not balance the stresses at vertex "));
}

TEST(NodalResidual, refuses_a_point_support_with_a_reaction) {
  Problem problem = example_1(Multiplier::force, 2);
  prescribe_dof(problem, 2 * 5 + 1, 0.01);  // the middle of the loaded side
  const ContactSolution<2> solution = solved(problem);
  EXPECT_TRUE(says(refusal([&] { equilibrated(problem, solution); }),
                   "at vertex 5 (0, 20)"));
}

RC_GTEST_PROP(NodalResidual, of_a_solid_is_what_the_loads_lack,
              (Random random)) {
  const LoadedSolid body = random_loaded_solid(irregular_solid(random), random);
  const VectorXd u = displacement(body.system());
  const NodalResidual<3> none = nodal_residual(
      body.topology, body.stress(u), body.body_loads, body.boundary());
  RC_ASSERT(none.missing.cwiseAbs().maxCoeff() < 1e-11 * none.scale);

  const VectorXd change = random_vector(u.size(), random);
  const NodalResidual<3> less =
      less_stress(body.topology, none, body.stress(change));
  const RowMatrix K = stiffness(body.mesh(), body.hooke);
  const VectorXd forces = K * change;
  const NodalResidual<3> again = with_forces(less, forces);
  RC_ASSERT(less.missing.cwiseAbs().maxCoeff() > 0.1);
  RC_ASSERT(again.missing.cwiseAbs().maxCoeff() < 1e-10);
}

}  // namespace
}  // namespace ffcontact
