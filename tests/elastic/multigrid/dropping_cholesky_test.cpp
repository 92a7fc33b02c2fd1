// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/dropping_cholesky.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

/// 1 -1 with rounding: a load along the kernel has no answer, and none is made up.
TEST(DroppingCholesky, drops_what_rounding_has_made_regular) {
  MatrixXd A(2, 2);
  A << 1e6, -1e6, -1e6, 1e6 * (1 + 1e-8);
  const DroppingCholesky factor(A);
  const VectorXf x = factor.solve(Eigen::Vector2f(2e6, -1e6));
  EXPECT_LT(x.norm(), 10);
  const VectorXf y = factor.solve(Eigen::Vector2f(1e6, -1e6));
  EXPECT_NEAR(y[0] - y[1], 1, 1e-6);
}

TEST(DroppingCholesky, leaves_out_what_is_held) {
  MatrixXd A = MatrixXd::Zero(2, 2);
  A(0, 0) = 4;
  const VectorXf x = DroppingCholesky(A).solve(Eigen::Vector2f(2, 3));
  EXPECT_EQ(x[0], 0.5f);
  EXPECT_EQ(x[1], 0);
}

}  // namespace
}  // namespace ffcontact
