// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/minimum/nonnegative_least_squares.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <limits>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Smallest |G x - b| over x >= 0 by brute force: least squares on every set of columns
/// whose answer is not negative.
double smallest_residual(const MatrixXd& G, const VectorXd& b) {
  double best = b.norm();
  for (int set = 1; set < 1 << G.cols(); ++set) {
    MatrixXd selected(G.rows(), 0);
    for (Index j = 0; j < G.cols(); ++j)
      if (set >> j & 1) {
        selected.conservativeResize(Eigen::NoChange, selected.cols() + 1);
        selected.rightCols(1) = G.col(j);
      }
    const VectorXd z = selected.colPivHouseholderQr().solve(b);
    if (z.minCoeff() >= 0) best = std::min(best, (selected * z - b).norm());
  }
  return best;
}

/// Largest violation of  x >= 0,  G'r <= 0,  x . G'r = 0  with r = b - G x, relative to
/// |b| and |G|.
double optimality_defect(const MatrixXd& G, const VectorXd& b,
                         const VectorXd& x) {
  const VectorXd descent = G.transpose() * (b - G * x) / (G.norm() * b.norm());
  const double x_scale =
      std::max(x.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  return std::max({-x.minCoeff() / x_scale, descent.maxCoeff(),
                   (x / x_scale).cwiseProduct(descent).cwiseAbs().maxCoeff()});
}

RC_GTEST_PROP(NonnegativeLeastSquares,
              residual_is_the_smallest_over_all_active_sets, (Random random)) {
  const int m = *rc::gen::inRange(1, 6), n = *rc::gen::inRange(1, 7);
  const MatrixXd G = random_matrix(m, n, random);
  const VectorXd b = random_vector(m, random),
                 x = nonnegative_least_squares(G, b);
  RC_ASSERT(x.minCoeff() >= 0);
  RC_ASSERT(std::abs((G * x - b).norm() - smallest_residual(G, b)) <
            1e-10 * b.norm());
}

RC_GTEST_PROP(NonnegativeLeastSquares, residual_descends_along_no_column,
              (Random random)) {
  const int m = *rc::gen::inRange(1, 12), n = *rc::gen::inRange(1, 20);
  const MatrixXd G = random_matrix(m, n, random);
  const VectorXd b = random_vector(m, random);
  RC_ASSERT(optimality_defect(G, b, nonnegative_least_squares(G, b)) < 1e-11);
}

RC_GTEST_PROP(NonnegativeLeastSquares, repeated_columns_do_no_harm,
              (Random random)) {
  const MatrixXd once = random_matrix(4, 3, random);
  const MatrixXd twice = once.replicate(1, 2);
  const VectorXd b = random_vector(4, random);
  RC_ASSERT(optimality_defect(twice, b, nonnegative_least_squares(twice, b)) <
            1e-11);
}

RC_GTEST_PROP(NonnegativeLeastSquares, a_right_side_inside_the_cone_is_reached,
              (Random random)) {
  const MatrixXd G = random_matrix(3, 6, random);
  const VectorXd b = G * random_vector(6, random).cwiseAbs();
  RC_ASSERT((G * nonnegative_least_squares(G, b) - b).norm() <
            1e-11 * b.norm());
}

/// A step that is not cut off where the first column reaches 0 ends at (0, 0, 3.19,
/// 0.37).
TEST(NonnegativeLeastSquares, columns_leave_one_after_the_other) {
  MatrixXd G(3, 4);
  G << 9, 7, 3, 0,  //
      0, 9, 2, 9,   //
      0, 4, 1, 2;
  const Vector3d b(9, 9, 7);
  EXPECT_LT(optimality_defect(G, b, nonnegative_least_squares(G, b)), 1e-12);
}

TEST(NonnegativeLeastSquares, a_right_side_opposite_to_all_columns_gives_zero) {
  const VectorXd x =
      nonnegative_least_squares(Matrix3d::Identity(), Vector3d(-1, -2, 0));
  EXPECT_EQ(x, Vector3d::Zero());
}

TEST(NonnegativeLeastSquares, optimality_defect_sees_one_spoiled_number) {
  Random random(1);
  const MatrixXd G = random_matrix(6, 4, random);
  const VectorXd b = random_vector(6, random);
  VectorXd x = nonnegative_least_squares(G, b);
  ASSERT_LT(optimality_defect(G, b, x), 1e-12);
  x[0] += 1e-3;
  EXPECT_GT(optimality_defect(G, b, x), 1e-6);
}

}  // namespace
}  // namespace ffcontact
