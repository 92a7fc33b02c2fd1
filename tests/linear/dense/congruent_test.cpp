// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/congruent.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace ffcontact::test {
namespace {

MatrixXd random_symmetric(Index n, std::mt19937& random) {
  const MatrixXd A = random_matrix(n, n, random);
  return A + A.transpose();
}

/// A third of the entries; one column in ten has none.
MatrixXd random_sparse(Index rows, Index cols, std::mt19937& random) {
  MatrixXd Q = random_matrix(rows, cols, random);
  for (Index j = 0; j < cols; ++j) {
    const bool empty = random() % 10 == 0;
    for (Index i = 0; i < rows; ++i)
      if (empty || random() % 3 != 0) Q(i, j) = 0;
  }
  return Q;
}

RC_GTEST_PROP(Congruent, is_the_product_of_three, (Random random)) {
  const Index n = *rc::gen::inRange(1, 40), m = *rc::gen::inRange(0, 40);
  const MatrixXd S = random_symmetric(n, random),
                 Q = random_sparse(n, m, random);
  const MatrixXd exact = Q.transpose() * (S * Q);
  const MatrixXd of_sparse = congruent(S, SparseMatrix(Q.sparseView())),
                 of_dense = congruent(S, Q);
  RC_ASSERT(of_sparse.rows() == m && of_sparse.cols() == m);
  RC_ASSERT((of_sparse - exact).norm() <= 1e-12);
  RC_ASSERT((of_dense - exact).norm() <= 1e-12);
}

TEST(Congruent, is_symmetric_to_the_last_digit) {
  Random random(1);
  const MatrixXd S = random_symmetric(150, random);
  const SparseMatrix Q = random_sparse(150, 130, random).sparseView();
  const MatrixXd result = congruent(S, Q);
  EXPECT_EQ(result, MatrixXd(result.transpose()));
}

}  // namespace
}  // namespace ffcontact::test
