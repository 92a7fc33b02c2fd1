// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/iterative/krylov.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "support/random.hpp"

namespace ffcontact::test {
namespace {

constexpr double no_limit = 1e300;

LinearMap times(const MatrixXd& A) {
  return [&A](const VectorXd& x) { return VectorXd(A * x); };
}

/// A matrix with these diagonal blocks in a basis that is not orthogonal.
MatrixXd in_other_basis(const MatrixXd& blocks, std::mt19937& random) {
  const Index n = blocks.rows();
  const MatrixXd X = MatrixXd::Identity(n, n) +
                     0.3 / std::sqrt(n) * random_matrix(n, n, random);
  return X * blocks * X.inverse();
}

RC_GTEST_PROP(krylov, largest_eigenvalue_is_that_of_eigen, (Random random)) {
  const auto n = static_cast<Index>(*rc::gen::inRange(1, 60));
  const MatrixXd B = random_matrix(n, n, random), A = B.transpose() * B;
  const double exact =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(A).eigenvalues().maxCoeff();
  const double ratio = largest_eigenvalue(times(A), n) / exact;
  RC_ASSERT(ratio > 1 - 1e-12 && ratio < 1 + 2e-8);
}

TEST(krylov, largest_eigenvalue_of_a_large_matrix_needs_few_products) {
  const Index n = 3000;
  const VectorXd d = VectorXd::LinSpaced(n, 0, 1).array().square();
  int products = 0;
  const double largest = largest_eigenvalue(
      [&](const VectorXd& x) {
        ++products;
        return VectorXd(d.cwiseProduct(x) +
                        3.0 / n * VectorXd::Constant(n, x.sum()));
      },
      n);
  // 1 = 3/n sum of 1 / (theta - d)
  EXPECT_NEAR(3.0 / n * (largest - d.array()).inverse().sum(), 1, 1e-8);
  EXPECT_LT(products, 60);
}

TEST(krylov, nothing_comes_of_nothing) {
  const MatrixXd none = MatrixXd::Zero(4, 4);
  EXPECT_EQ(largest_eigenvalue(times(none), 4), 0);
  EXPECT_EQ(largest_eigenvalue(times(none), 0), 0);
  EXPECT_EQ(largest_real_eigenvalue(times(none), 4, no_limit), 0);
}

RC_GTEST_PROP(krylov, largest_real_eigenvalue_among_complex_ones,
              (Random random)) {
  const auto pairs = static_cast<Index>(*rc::gen::inRange(1, 40));
  const Index n = 2 * pairs + 3;
  MatrixXd blocks = MatrixXd::Zero(n, n);
  for (Index k = 0; k < pairs; ++k) {
    const Vector2d z = random_vector(2, random);
    blocks.block<2, 2>(2 * k, 2 * k) << z[0], z[1] + 2, -z[1] - 2, z[0];
  }
  const double largest = *real(0.3, 0.9);
  blocks(n - 3, n - 3) = largest;
  blocks(n - 2, n - 2) = largest - 0.2;
  blocks(n - 1, n - 1) = -2;
  const MatrixXd A = in_other_basis(blocks, random);
  const auto below = [&](double limit) {
    return largest_real_eigenvalue(times(A), n, limit);
  };
  RC_ASSERT(std::abs(below(no_limit) - largest) < 1e-7);
  RC_ASSERT(std::abs(below(largest - 0.1) - (largest - 0.2)) < 1e-7);
  RC_ASSERT(largest_real_eigenvalue(times(A), n, 0) == 0);
}

/// Rounding makes some of them positive.
RC_GTEST_PROP(krylov, eigenvalue_0_is_none, (Random random)) {
  VectorXd values = -random_vector(20, random).cwiseAbs();
  values.head(3).setZero();
  const MatrixXd A = in_other_basis(values.asDiagonal(), random);
  RC_ASSERT(largest_real_eigenvalue(times(A), 20, no_limit) == 0);
}

}  // namespace
}  // namespace ffcontact::test
