// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/line_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "support/problems.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

MatrixXd motions_of(const Problem& problem) {
  return free_rigid_motions(problem.mesh, Flags(problem.b.size(), 0));
}

/// Works of all unit forces at a node, n then t, along the motions.
MatrixXd works(const Problem& problem, const MatrixXd& motions) {
  return (weight_of_rows(problem.law.multiplier, problem.line) *
          traces_of(problem.line, motions))
      .transpose();
}

/// -n and -n +- mu t of size 1: what spans Coulomb's cone.
RC_GTEST_PROP(LineBalance, cones_are_spanned_by_their_edges, (Random random)) {
  const double mu = *rc::gen::element(0.0, 0.3, 2.0, 1e8);
  Problem problem = body(rotated(irregular(4, 2, 4, 2, random), *real(-3, 3)),
                         material(1, 0));
  problem.law.multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  set_friction(problem, mu);
  const MatrixXd motions = motions_of(problem), all = works(problem, motions),
                 forces = extreme_forces(problem.line, problem.law, motions);
  RC_ASSERT(forces.cols() == 3 * problem.line.node_count());
  for (int i = 0; i < problem.line.node_count(); ++i) {
    const VectorXd n = all.col(2 * i), t = all.col(2 * i + 1);
    const double angle = std::atan(mu);
    RC_ASSERT((forces.col(3 * i) + n).norm() < 1e-13);
    RC_ASSERT(
        (forces.col(3 * i + 1) + std::cos(angle) * n - std::sin(angle) * t)
            .norm() < 1e-13);
    RC_ASSERT(
        (forces.col(3 * i + 2) + std::cos(angle) * n + std::sin(angle) * t)
            .norm() < 1e-13);
  }
}

TEST(LineBalance, trescas_bound_holds_either_way) {
  Problem problem = body(rectangle(2, 1, 2, 1), material(1, 0));
  problem.law.friction.resize(0);
  problem.law.slip_bound = Vector3d(0, 3, 1e-9);
  const MatrixXd motions = motions_of(problem), all = works(problem, motions),
                 forces = extreme_forces(problem.line, problem.law, motions);
  for (int i = 0; i < 3; ++i) {
    const VectorXd t = (i == 0 ? 0 : 1) * all.col(2 * i + 1);
    EXPECT_EQ(forces.col(3 * i), -all.col(2 * i));
    EXPECT_EQ(forces.col(3 * i + 1), t);
    EXPECT_EQ(forces.col(3 * i + 2), -t);
  }
}

}  // namespace
}  // namespace ffcontact
