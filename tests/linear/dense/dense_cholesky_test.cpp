// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/dense_cholesky.hpp"

#include "support/random.hpp"
#include "support/threads.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(DenseCholesky, solves, (Random random)) {
  const auto n = static_cast<Index>(random() % 600);  // three tiles
  const MatrixXd B = random_matrix(n, n, random),
                 H = B * B.transpose() + MatrixXd::Identity(n, n);
  const VectorXd x = random_vector(n, random);
  const MatrixXd lower = H.triangularView<Eigen::Lower>();
  const DenseCholesky cholesky(lower);
  RC_ASSERT(cholesky.is_positive_definite());
  RC_ASSERT((cholesky.solve(H * x) - x).norm() <=
            1e-11 * static_cast<double>(n));
}

TEST(DenseCholesky, has_the_same_digits_for_any_number_of_threads) {
  std::mt19937 random;
  const MatrixXd B = random_matrix(900, 900, random),
                 H = B * B.transpose() + MatrixXd::Identity(900, 900);
  const VectorXd b = random_vector(900, random);
  const auto solve = [&] { return DenseCholesky(H).solve(b); };
  EXPECT_EQ(on_threads(2, solve), on_threads(1, solve));
}

TEST(DenseCholesky, knows_what_is_not_positive_definite) {
  EXPECT_FALSE(DenseCholesky(-MatrixXd::Identity(2, 2)).is_positive_definite());
  MatrixXd last = MatrixXd::Identity(600, 600);
  last(599, 599) = -1;
  EXPECT_FALSE(DenseCholesky(last).is_positive_definite());
  EXPECT_FALSE(DenseCholesky().is_positive_definite());
}

}  // namespace
}  // namespace ffcontact
