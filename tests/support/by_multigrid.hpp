// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/linear/norms.hpp"
#include "support/solid_problems.hpp"
#include "support/solid_stacks.hpp"

/// Solids by multigrid and by a factor.
namespace ffcontact::test {

inline ContactSettings by(LinearSolver linear) {
  ContactSettings settings;
  settings.linear = linear;
  return settings;
}

/// By multigrid and by a factor.
inline void expect_same(const SolidProblem& problem) {
  const ContactSolution<3> one = problem.solve(by(LinearSolver::multigrid)),
                           other = problem.solve(by(LinearSolver::direct));
  ASSERT_TRUE(one.accepted({}));
  ASSERT_TRUE(other.accepted({}));
  EXPECT_EQ(one.multigrid, Multigrid::used);
  EXPECT_EQ(other.multigrid, Multigrid::unused);
  EXPECT_LE(max_norm(one.force - other.force), 1e-8 * max_norm(other.force));
  EXPECT_LE(max_norm(one.displacement - other.displacement),
            1e-8 * max_norm(other.displacement));
  EXPECT_EQ(one.state, other.state);
}

/// A problem by multigrid from nothing, and from its own answer.
struct ColdAndWarm {
  ContactSolution<3> cold, warm;

  explicit ColdAndWarm(const SolidProblem& problem) {
    ContactSettings settings = by(LinearSolver::multigrid);
    cold = problem.solve(settings);
    const ContactLaw<3> beyond =
        on_layer(problem.law, lumped_pressures(problem.surface, cold.force));
    const Matrix3Xd v = displacement_against_foundation(problem.surface, beyond,
                                                        cold.displacement);
    settings.near = {cold.force.reshaped(), v.reshaped()};
    warm = problem.solve(settings);
    EXPECT_LE(warm.iterations, 5);
    EXPECT_LE(max_norm(warm.force - cold.force), 1e-9 * max_norm(cold.force));
  }
};

/// Makes the first body of a stack so many times as stiff.
inline void stiffen(double factor, SolidStack& stack) {
  RowMatrix& A = stack.problem.A;
  const Index end = 3 * stack.joined.first_vertex[1];
  for (Index k = 0; k < end; ++k)
    for (RowMatrix::InnerIterator e(A, k); e; ++e)
      if (e.value() != 1e30) e.valueRef() *= factor;
}

/// A brick on a larger one that is held, whose meshes do not match.
inline SolidStack brick_on_a_larger_one(double mu, double stiffness) {
  Random random(1);
  SolidStack stack({random_brick({6, 6, 3}, {0.4, 0.3, 0}, {2, 1.3, 1}, random),
                    random_brick({9, 6, 3}, {0, 0, -1}, {3, 2, 1}, random)},
                   mu);
  stiffen(stiffness, stack);
  stack.problem.move(stack.label(1, low_z),
                     [](const Vector3d&) { return Vector3d::Zero(); });
  return stack;
}

/// The same, its top moved down, along and about y.
inline SolidStack block_on_a_block(double mu, double stiffness) {
  SolidStack stack = brick_on_a_larger_one(mu, stiffness);
  stack.problem.move(stack.label(0, high_z), [](const Vector3d& x) {
    return Vector3d(2e-3, 1e-3, -1e-3 * (x.x() - 0.8));
  });
  return stack;
}

}  // namespace ffcontact::test
