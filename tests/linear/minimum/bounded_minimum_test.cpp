// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/minimum/bounded_minimum.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Largest violation of: gradient 0 inside the bounds, not inwards at them.
double defect(const MatrixXd& H, const VectorXd& h, const VectorXd& low,
              const VectorXd& high, const VectorXd& x) {
  const VectorXd gradient = H * x + h;
  double largest = std::max((low - x).maxCoeff(), (x - high).maxCoeff());
  for (Index i = 0; i < x.size(); ++i) {
    if (x[i] > low[i]) largest = std::max(largest, gradient[i]);
    if (x[i] < high[i]) largest = std::max(largest, -gradient[i]);
  }
  return largest;
}

RC_GTEST_PROP(BoundedMinimum, holds_every_condition, (Random random)) {
  const Index n = *rc::gen::inRange(1, 40);
  const MatrixXd root = random_matrix(n, n, random);
  const MatrixXd H = root * root.transpose() + 1e-3 * MatrixXd::Identity(n, n);
  const VectorXd h = random_vector(n, random);
  VectorXd low = -random_vector(n, random).cwiseAbs(),
           high = random_vector(n, random).cwiseAbs();
  for (Index i = 0; i < n; ++i) {  // some are free to one side, or not at all
    if (random() % 4 == 0) low[i] = -std::numeric_limits<double>::infinity();
    if (random() % 4 == 0) high[i] = low[i] = 0;
  }
  const BoundedMinimum minimum =
      bounded_minimum(H, h, low, high, 10 * random_vector(n, random), 1000);
  RC_ASSERT(defect(H, h, low, high, minimum.x) < 1e-10);
  RC_ASSERT(minimum.steps <= 5 * n + 5);
}

TEST(BoundedMinimum,
     a_clamped_step_that_would_not_lower_the_function_ends_at_the_first_bound) {
  const Matrix2d H = (Matrix2d() << 1, 0.99, 0.99, 1).finished();
  const Vector2d h(-10, 9.9), low(-20, -20), high(0.5, 20);
  const BoundedMinimum minimum =
      bounded_minimum(H, h, low, high, Vector2d(0, 0), 100);
  EXPECT_LT(defect(H, h, low, high, minimum.x), 1e-12);
}

/// From a corner of the bounds the minimum lies on another face than the first, and x'Hx
/// grows on the way to it.
RC_GTEST_PROP(BoundedMinimum, goes_on_while_faces_lower_the_function,
              (Random random)) {
  const MatrixXd root = random_matrix(8, 8, random);
  const MatrixXd H = root * root.transpose() + 1e-3 * MatrixXd::Identity(8, 8);
  const VectorXd h = random_vector(8, random),
                 high = random_vector(8, random).cwiseAbs(), low = -high;
  RC_ASSERT(defect(H, h, low, high,
                   bounded_minimum(H, h, low, high, low, 1000).x) < 1e-10);
}

TEST(BoundedMinimum, stops_after_the_steps_it_is_given) {
  const MatrixXd H = MatrixXd::Identity(3, 3);
  const VectorXd h = Vector3d(-1, -2, -3), low = Vector3d::Constant(-1),
                 high = -low;
  EXPECT_EQ(bounded_minimum(H, h, low, high, Vector3d::Zero(), 0).steps, 0);
  EXPECT_EQ(bounded_minimum(H, h, low, high, Vector3d::Zero(), 100).x, high);
}

}  // namespace
}  // namespace ffcontact
