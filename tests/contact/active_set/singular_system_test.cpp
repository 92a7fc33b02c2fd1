// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set/singular_system.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Springs between n points in a row, held by nothing: they move as one.
MatrixXd free_springs(int n) {
  MatrixXd A = MatrixXd::Zero(n, n);
  for (int k = 0; k + 1 < n; ++k)
    A.block<2, 2>(k, k) += (Matrix2d() << 1, -1, -1, 1).finished();
  return A;
}

RC_GTEST_PROP(SingularSystem, is_solved_where_it_is_not_singular,
              (Random random)) {
  const Index n = *rc::gen::inRange(0, 30);
  const MatrixXd A = random_matrix(n, n, random) + 5 * MatrixXd::Identity(n, n);
  const VectorXd x = random_vector(n, random);
  SystemKind kind = SystemKind::inconsistent;
  RefinedSolver solver;
  const VectorXd found = solved(A.transpose(), A * x, n, kind, solver);
  RC_ASSERT(kind == SystemKind::regular);
  RC_ASSERT((found - x).norm() < 1e-10);
}

/// The smallest solution does not move all points as one.
TEST(SingularSystem, has_the_smallest_solution_where_loads_are_in_balance) {
  const MatrixXd A = free_springs(6);
  const VectorXd b = (VectorXd(6) << 1, 0, 0, 0, 0, -1).finished();
  SystemKind kind;
  RefinedSolver solver;
  const VectorXd x = solved(A, b, 6, kind, solver);
  EXPECT_EQ(kind, SystemKind::consistent);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(x[k], 2.5 - k, 1e-12);
}

/// On a leash of 1e-8: x = b / 1e-8 along the motion that is left free.
TEST(SingularSystem, lets_go_what_is_pushed) {
  const MatrixXd A = free_springs(6);
  SystemKind kind;
  RefinedSolver solver;
  const VectorXd x = solved(A, VectorXd::Ones(6), 6, kind, solver);
  EXPECT_EQ(kind, SystemKind::inconsistent);
  EXPECT_LT((x - VectorXd::Constant(6, 1e8)).norm(), 1e2);
  // with two unknowns on it the others follow
  const VectorXd two = solved(A, VectorXd::Ones(6), 2, kind, solver);
  EXPECT_NEAR(two[0] + two[1], 6e8, 1e3);
}

}  // namespace
}  // namespace ffcontact
