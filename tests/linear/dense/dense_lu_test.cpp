// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/dense_lu.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "support/random.hpp"
#include "support/threads.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(DenseLu, solves, (Random random)) {
  const int n = *rc::gen::inRange(1, 20);
  const MatrixXd A =
      random_matrix(n, n, random) + 2 * n * MatrixXd::Identity(n, n);
  const VectorXd x = random_vector(n, random);
  RC_ASSERT((DenseLu(A).solve(A * x) - x).norm() < 1e-13 * x.norm());
}

RC_GTEST_PROP(DenseLu, exchanges_rows_across_tiles, (Random random)) {
  const int n = *rc::gen::inRange(1, 400);
  const MatrixXd A = random_matrix(n, n, random);
  const VectorXd x = random_vector(n, random);
  const DenseLu lu(A);
  const double limit =
      1e-14 * n * std::sqrt(n) / lu.reciprocal_condition() * x.norm();
  RC_ASSERT((lu.solve(A * x) - x).norm() <= limit);
  RC_ASSERT((lu.solve_transposed(A.transpose() * x) - x).norm() <= limit);
  RC_ASSERT(lu.determinant_sign() ==
            (Eigen::PartialPivLU<MatrixXd>(A).determinant() > 0 ? 1 : -1));
}

TEST(DenseLu, has_the_same_digits_for_any_number_of_threads) {
  std::mt19937 random;
  const MatrixXd A = random_matrix(900, 900, random);
  const VectorXd b = random_vector(900, random);
  const auto solve = [&] { return DenseLu(A).solve(b); };
  EXPECT_EQ(on_threads(2, solve), on_threads(1, solve));
}

TEST(DenseLu, reciprocal_condition_of_a_diagonal_is_the_ratio_of_its_ends) {
  const Vector3d diagonal(1, -4, 1e-3);
  EXPECT_NEAR(DenseLu(diagonal.asDiagonal()).reciprocal_condition(), 1e-3 / 4,
              1e-15);
}

TEST(DenseLu, reciprocal_condition_of_a_singular_matrix_is_zero) {
  EXPECT_LT(DenseLu(Matrix2d::Ones()).reciprocal_condition(), 1e-15);
  EXPECT_EQ(DenseLu(Matrix2d::Zero()).reciprocal_condition(), 0);
}

TEST(DenseLu, reciprocal_condition_of_what_is_no_number_is_zero) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(DenseLu(Matrix2d::Constant(nan)).reciprocal_condition(), 0);
  EXPECT_EQ(DenseLu(Vector2d(infinity, 1).asDiagonal()).reciprocal_condition(),
            0);
}

}  // namespace
}  // namespace ffcontact
