// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/symmetric_eigen.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/pi.hpp"
#include "support/random.hpp"

namespace ffcontact::test {
namespace {

RC_GTEST_PROP(SymmetricEigen, takes_the_lower_triangle_apart, (Random random)) {
  const Index n = *rc::gen::inRange(1, 50);
  const MatrixXd any = random_matrix(n, n, random);
  const MatrixXd A = any.selfadjointView<Eigen::Lower>();
  const SymmetricEigen eigen = symmetric_eigen(any);
  const MatrixXd& V = eigen.vectors;
  RC_ASSERT((V.transpose() * V - MatrixXd::Identity(n, n)).norm() < 1e-12);
  RC_ASSERT((A * V - V * eigen.values.asDiagonal()).norm() < 1e-12 * n);
  for (Index k = 1; k < n; ++k)
    RC_ASSERT(eigen.values[k - 1] <= eigen.values[k]);
}

/// 2 - 2 cos(k pi/(n + 1)) of second differences.
TEST(SymmetricEigen, has_the_frequencies_of_a_string) {
  const Index n = 30;
  MatrixXd A = 2 * MatrixXd::Identity(n, n);
  A.diagonal(-1).setConstant(-1);
  const SymmetricEigen eigen = symmetric_eigen(A);
  for (Index k = 0; k < n; ++k)
    EXPECT_NEAR(eigen.values[k],
                2 - 2 * std::cos(static_cast<double>(k + 1) * pi / (n + 1)),
                1e-14);
}

TEST(SymmetricEigen, of_nothing_is_nothing) {
  EXPECT_EQ(symmetric_eigen(MatrixXd(0, 0)).values.size(), 0);
}

}  // namespace
}  // namespace ffcontact::test
