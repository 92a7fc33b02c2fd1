// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/cholesky.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(Cholesky, solves, (Random random)) {
  const MatrixXd half = random_matrix(5, 5, random);
  const MatrixXd H = half * half.transpose() + MatrixXd::Identity(5, 5);
  const VectorXd x = random_vector(5, random);
  const MatrixXd X = random_matrix(5, 3, random);
  const Cholesky cholesky(H);
  RC_ASSERT(cholesky.is_positive_definite());
  RC_ASSERT((cholesky.solve(H * x) - x).norm() < 1e-11 * H.norm());
  RC_ASSERT((cholesky.solve_columns(H * X) - X).norm() < 1e-11 * H.norm());
  RC_ASSERT((cholesky.other_half_solve(cholesky.half_solve(H * x)) - x).norm() <
            1e-11 * H.norm());
  // |L^-1 b|^2 = b' H^-1 b tells L from L'.
  RC_ASSERT(std::abs(cholesky.half_solve(H * x).squaredNorm() - x.dot(H * x)) <
            1e-11 * H.squaredNorm());
}

TEST(Cholesky, knows_what_is_not_positive_definite_and_how_close_others_are) {
  EXPECT_FALSE(Cholesky(Vector2d(1, -1).asDiagonal()).is_positive_definite());
  EXPECT_NEAR(
      Cholesky(Vector3d(1, 4, 1e-3).asDiagonal()).reciprocal_condition(),
      1e-3 / 4, 1e-15);
}

}  // namespace
}  // namespace ffcontact
