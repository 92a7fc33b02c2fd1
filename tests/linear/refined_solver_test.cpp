// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/refined_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

MatrixXd random_square(Index n, Random& random) {
  MatrixXd A(n, n);
  for (Index j = 0; j < n; ++j) A.col(j) = random_vector(n, random);
  return A;
}

RC_GTEST_PROP(RefinedSolver, is_that_of_double_precision, (Random random)) {
  const Index n = *rc::gen::inRange(1, 60);
  const MatrixXd A = random_square(n, random) +
                     static_cast<double>(n) * MatrixXd::Identity(n, n);
  const VectorXd b = 1e60 * random_vector(n, random);
  const std::optional<VectorXd> x =
      RefinedSolver().solve_transposed(A.transpose(), b);
  RC_ASSERT(x.has_value());
  RC_ASSERT((*x - A.partialPivLu().solve(b)).norm() < 1e-13 * x->norm());
}

/// With the factors of the first, and where these are of no use with its own.
RC_GTEST_PROP(RefinedSolver, of_the_next_system_is_as_good, (Random random)) {
  const Index n = *rc::gen::inRange(1, 60);
  const double change = *rc::gen::element(1e-9, 1e-3, 0.1, 1.0);
  const MatrixXd A = random_square(n, random) +
                     static_cast<double>(n) * MatrixXd::Identity(n, n);
  const MatrixXd B = A + change * static_cast<double>(n) *
                             random_square(n, random).cwiseAbs2();
  const VectorXd b = random_vector(n, random);
  RefinedSolver solver;
  solver.solve_transposed(A.transpose(), b);
  const std::optional<VectorXd> x = solver.solve_transposed(B.transpose(), b);
  if (!x) return;
  const double norm = B.cwiseAbs().rowwise().sum().maxCoeff();
  RC_ASSERT((b - B * *x).cwiseAbs().maxCoeff() <=
            1e-14 * norm * x->cwiseAbs().maxCoeff());
}

TEST(RefinedSolver, of_a_zero_load_is_zero) {
  EXPECT_EQ(RefinedSolver().solve_transposed(2 * MatrixXd::Identity(3, 3),
                                             VectorXd::Zero(3)),
            VectorXd(VectorXd::Zero(3)));
}

TEST(RefinedSolver, is_left_to_others_where_the_matrix_is_nearly_singular) {
  Random random(2);
  MatrixXd A = random_square(20, random);
  A.col(7) = A.col(3) + 1e-9 * A.col(5);
  EXPECT_FALSE(RefinedSolver().solve_transposed(A, VectorXd::Ones(20)));
  A.col(7) = A.col(3);
  EXPECT_FALSE(RefinedSolver().solve_transposed(A, VectorXd::Ones(20)));
  A(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(RefinedSolver().solve_transposed(A, VectorXd::Ones(20)));
}

}  // namespace
}  // namespace ffcontact
