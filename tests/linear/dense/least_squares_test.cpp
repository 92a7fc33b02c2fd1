// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/least_squares.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A matrix of the given rank.
MatrixXd of_rank(int rows, int columns, int rank, Random& random) {
  return random_matrix(rows, rank, random) *
         random_matrix(rank, columns, random);
}

RC_GTEST_PROP(LeastSquares,
              leave_a_residual_across_the_columns_and_are_the_smallest_that_do,
              (Random random)) {
  const MatrixXd A = of_rank(7, 5, 3, random);
  const VectorXd b = random_vector(7, random), x = least_squares(A, b, {1e-10});
  RC_ASSERT((A.transpose() * (A * x - b)).norm() <
            1e-11 * A.norm() * (A.norm() * x.norm() + b.norm()));
  const MatrixXd kernel = kernel_basis(A, {1e-10});
  RC_ASSERT(kernel.cols() == 2);
  RC_ASSERT((kernel.transpose() * x).norm() < 1e-9 * kernel.norm() * x.norm());
}

RC_GTEST_PROP(LeastSquares, of_columns_are_those_of_each_column,
              (Random random)) {
  const MatrixXd A = random_matrix(7, 4, random),
                 B = random_matrix(7, 2, random);
  const MatrixXd X = least_squares_of_columns(A, B);
  for (int c = 0; c < 2; ++c)
    RC_ASSERT((X.col(c) - least_squares(A, B.col(c))).norm() < 1e-9 * X.norm());
}

TEST(LeastSquares, count_pivots_below_the_threshold_as_zero) {
  const MatrixXd A = Vector2d(1, 1e-6).asDiagonal();
  const Vector2d b(1, 1);
  EXPECT_NEAR(least_squares(A, b)[1], 1e6, 1e-6);
  EXPECT_NEAR(least_squares(A, b, {1e-5})[1], 0, 1e-15);
}

RC_GTEST_PROP(KernelBasis, spans_what_the_matrix_makes_zero, (Random random)) {
  const MatrixXd A = of_rank(4, 6, 3, random),
                 kernel = kernel_basis(A, {1e-10});
  RC_ASSERT(kernel.cols() == 3);
  RC_ASSERT((A * kernel).norm() < 1e-11 * A.norm() * kernel.norm());
}

TEST(KernelBasis, has_no_column_where_there_is_none_but_zero) {
  EXPECT_EQ(kernel_basis(Matrix2d::Identity()).cols(), 0);
  EXPECT_EQ(kernel_basis(Vector2d(1, 1e-6).asDiagonal()).cols(), 0);
  EXPECT_EQ(kernel_basis(Vector2d(1, 1e-6).asDiagonal(), {1e-5}).cols(), 1);
}

}  // namespace
}  // namespace ffcontact
