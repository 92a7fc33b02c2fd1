// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/sparse_lu.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(SparseLu, solves_with_the_matrix_and_its_transpose,
              (Random random)) {
  const MatrixXd A =
      random_matrix(6, 6, random) + 12 * MatrixXd::Identity(6, 6);
  const VectorXd x = random_vector(6, random);
  const MatrixXd X = random_matrix(6, 2, random);
  const SparseLu lu(A.sparseView());
  RC_ASSERT(lu.is_regular());
  RC_ASSERT((lu.solve(A * x) - x).norm() < 1e-13 * 12);
  RC_ASSERT((lu.solve_columns(A * X) - X).norm() < 1e-13 * 12);
  RC_ASSERT((lu.solve_transposed(A.transpose() * x) - x).norm() < 1e-13 * 12);
  RC_ASSERT((lu.solve_transposed_columns(A.transpose() * X) - X).norm() <
            1e-13 * 12);
}

/// Of any permutation, pattern and number of columns.
RC_GTEST_PROP(SparseLu, transforms_symmetric_matrices, (Random random)) {
  const Index n = *rc::gen::inRange(1, 40);
  MatrixXd A = random_matrix(n, n, random);
  A = (A.array().abs() < 0.2).select(A, 0);
  for (Index i = 0; i < n; ++i) A(i, (i + 3) % n) += 4;
  const MatrixXd half = random_matrix(n, n, random),
                 S = half + half.transpose();
  const SparseLu lu(A.sparseView());
  const MatrixXd T = lu.congruent(S);
  RC_ASSERT((A.transpose() * T * A - S).norm() < 1e-12 * S.norm());
  RC_ASSERT(T == T.transpose());
}

TEST(SparseLu, takes_no_columns_and_knows_a_singular_matrix) {
  const SparseLu lu(MatrixXd::Identity(3, 3).sparseView());
  EXPECT_EQ(lu.solve_columns(MatrixXd(3, 0)).cols(), 0);
  EXPECT_EQ(lu.solve_transposed_columns(MatrixXd(3, 0)).cols(), 0);
  EXPECT_EQ(lu.congruent(MatrixXd::Ones(3, 3)), MatrixXd::Ones(3, 3));
  EXPECT_FALSE(SparseLu(MatrixXd::Ones(2, 2).sparseView()).is_regular());
}

}  // namespace
}  // namespace ffcontact
