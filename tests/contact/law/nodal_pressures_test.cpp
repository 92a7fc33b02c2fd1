// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/nodal_pressures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cases.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The bottom of example 1 on four cells, with five nodes; u_x = 0 at the last one.
Problem five_nodes() { return example_1(Multiplier::force, 2); }

Matrix2Xd consistent(const Problem& problem, const Matrix2Xd& force) {
  return consistent_pressures(problem.line, prescribed_dofs(problem.A), force);
}

TEST(NodalPressures,
     solve_the_mass_matrix_without_the_forces_that_load_no_body) {
  const Problem problem = five_nodes();
  const Matrix2Xd expected =
      (Matrix2Xd(2, 5) << -1, -2, -3, -4, -5, 5, 4, 3, 2, 0).finished();
  Matrix2Xd force = expected * contact_mass(problem.line);
  force(1, 4) = std::nan("");  // must not be read
  EXPECT_LT(relative_difference(consistent(problem, force), expected), 1e-14);
}

/// At a clamped node, be it the last or one between others, the pressure is that of a
/// neighbour, and the loads of all other nodes are their forces.
TEST(NodalPressures,
     are_continued_to_clamped_nodes_and_keep_the_forces_of_the_others) {
  for (const int clamped : {0, 2, 4}) {
    Problem problem = five_nodes();
    for (int c = 0; c < 2; ++c)
      prescribe_dof(problem, 2 * problem.line.vertex[clamped] + c, 0);
    Random random(clamped);
    const Matrix2Xd force = random_matrix(2, 5, random);
    const Matrix2Xd pressure = consistent(problem, force),
                    loads = pressure * contact_mass(problem.line);
    for (int i = 0; i < 5; ++i) {
      if (i == clamped) continue;
      EXPECT_NEAR(loads(0, i), force(0, i), 1e-13);
      if (i < 4) {
        EXPECT_NEAR(loads(1, i), force(1, i), 1e-13);
      }
    }
    const int before = std::max(clamped - 1, 0),
              after = std::min(clamped + 1, 4);
    EXPECT_TRUE(pressure(0, clamped) == pressure(0, before) ||
                pressure(0, clamped) == pressure(0, after));
  }
}

RC_GTEST_PROP(NodalPressures,
              lumped_are_in_the_cone_with_the_resultant_of_the_forces, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  const ContactSolution<2> solution = solved(problem);
  const Matrix2Xd p = lumped_pressures(problem.line, solution.force);
  const double largest = p.cwiseAbs().maxCoeff();
  const VectorXd lengths = nodal_lengths(problem.line);
  RC_ASSERT(std::abs(lengths.sum() - problem.line.length.sum()) <=
            1e-13 * lengths.sum());
  RC_ASSERT((p * lengths - solution.force.rowwise().sum()).norm() <=
            1e-13 * largest * lengths.sum());
  if (problem.law.multiplier == Multiplier::pressure) return;
  RC_ASSERT(p.row(0).maxCoeff() <= 0);
  for (int i = 0; i < problem.line.node_count(); ++i)
    RC_ASSERT(std::abs(p(1, i)) <=
              -problem.law.friction[i] * p(0, i) + 1e-10 * largest);
}

RC_GTEST_PROP(NodalPressures,
              of_a_script_stand_for_the_multipliers_of_the_solver, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  const ContactSolution<2> solution = solved(problem);
  const std::vector<char> prescribed = prescribed_dofs(problem.A);
  const Multiplier multiplier = problem.law.multiplier;
  const Matrix2Xd p = multiplier == Multiplier::force
                          ? lumped_pressures(problem.line, solution.force)
                          : solution.pressure;
  const Matrix2Xd again =
      multiplier_density(problem.line, multiplier, prescribed, p);
  RC_ASSERT((again - solution.pressure).cwiseAbs().maxCoeff() <=
            1e-12 * solution.pressure.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace ffcontact
