// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/minimum/quadratic_minimum.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <limits>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// min y'Hy / 2 + g'y subject to C y >= d.
struct Quadratic {
  MatrixXd H, C;
  VectorXd g, d;
  double value(const VectorXd& y) const {
    return 0.5 * y.dot(H * y) + g.dot(y);
  }
  double violation(const VectorXd& y) const {
    return d.size() > 0 ? std::max(0.0, (d - C * y).maxCoeff()) : 0;
  }
};

/// A problem for which a random y is feasible.
Quadratic random_quadratic(int unknowns, int conditions, Random& random) {
  const MatrixXd A = random_matrix(unknowns, unknowns, random);
  Quadratic q{A * A.transpose() + 0.1 * MatrixXd::Identity(unknowns, unknowns),
              random_matrix(conditions, unknowns, random),
              random_vector(unknowns, random),
              {}};
  q.d = q.C * random_vector(unknowns, random) -
        random_vector(conditions, random).cwiseAbs();
  return q;
}

/// Smallest value by brute force: every set of conditions taken as equations, the
/// feasible points compared.
double smallest_value(const Quadratic& q) {
  const Index n = q.g.size();
  double best = std::numeric_limits<double>::infinity();
  for (int set = 0; set < 1 << q.d.size(); ++set) {
    std::vector<int> rows;
    for (int row = 0; row < q.d.size(); ++row)
      if (set >> row & 1) rows.push_back(row);
    const auto m = static_cast<Index>(rows.size());
    if (m > n) continue;
    MatrixXd saddle = MatrixXd::Zero(n + m, n + m);
    saddle.topLeftCorner(n, n) = q.H;
    saddle.bottomLeftCorner(m, n) = q.C(rows, Eigen::all);
    saddle.topRightCorner(n, m) = q.C(rows, Eigen::all).transpose();
    VectorXd right(n + m);
    right << -q.g, q.d(rows);
    const VectorXd y = saddle.fullPivLu().solve(right).head(n);
    if (q.violation(y) < 1e-9) best = std::min(best, q.value(y));
  }
  return best;
}

RC_GTEST_PROP(QuadraticMinimum,
              is_the_smallest_over_all_sets_of_active_conditions,
              (Random random)) {
  const Quadratic q = random_quadratic(*rc::gen::inRange(1, 6),
                                       *rc::gen::inRange(1, 7), random);
  const auto y = quadratic_minimum(q.H, q.g, q.C, q.d);
  RC_ASSERT(y.has_value());
  RC_ASSERT(q.violation(*y) < 1e-9);
  RC_ASSERT(std::abs(q.value(*y) - smallest_value(q)) < 1e-8);
}

RC_GTEST_PROP(QuadraticMinimum, without_active_conditions_is_the_free_minimum,
              (Random random)) {
  Quadratic q = random_quadratic(4, 3, random);
  q.d.array() -= 1e6;
  const auto y = quadratic_minimum(q.H, q.g, q.C, q.d);
  RC_ASSERT(y.has_value());
  RC_ASSERT((q.H * *y + q.g).norm() < 1e-11 * y->norm() * q.H.norm());
}

RC_GTEST_PROP(QuadraticMinimum, does_not_depend_on_the_scale_of_its_conditions,
              (Random random)) {
  const Quadratic q = random_quadratic(4, 5, random);
  const VectorXd factor = (5 * random_vector(5, random)).array().exp();
  const auto y = quadratic_minimum(q.H, q.g, q.C, q.d);
  const auto z = quadratic_minimum(q.H, q.g, factor.asDiagonal() * q.C,
                                   factor.asDiagonal() * q.d);
  RC_ASSERT((y && z && (*y - *z).norm() < 1e-8 * (1 + y->norm())));
}

/// |y_t| <= -mu y_n for two pairs (y_n, y_t), as for the tractions at the ends of an
/// edge.
RC_GTEST_PROP(QuadraticMinimum, meets_the_conditions_of_a_thin_cone_to_rounding,
              (Random random)) {
  const double mu = std::pow(10.0, -*real(0, 7));
  Quadratic q = random_quadratic(4, 4, random);
  q.C.setZero();
  for (int pair = 0; pair < 2; ++pair)
    q.C.block<2, 2>(2 * pair, 2 * pair) << -mu, 1, -mu, -1;
  q.d.setZero();
  const auto y = quadratic_minimum(q.H, q.g, q.C, q.d);
  RC_ASSERT(y.has_value());
  RC_ASSERT(q.violation(*y) <= 1e-14 * (1 + y->norm()));
  // Optimality: the gradient is a combination of the active conditions with multipliers
  // >= 0.
  const VectorXd gradient = q.H * *y + q.g, slack = q.C * *y - q.d;
  MatrixXd active(4, 0);
  for (int row = 0; row < 4; ++row)
    if (slack[row] <= 1e-13 * (1 + y->norm())) {
      active.conservativeResize(Eigen::NoChange, active.cols() + 1);
      active.rightCols<1>() = q.C.row(row).transpose();
    }
  VectorXd left_over = gradient;
  if (active.cols() > 0) {
    const VectorXd multipliers =
        active.completeOrthogonalDecomposition().solve(gradient);
    RC_ASSERT(multipliers.minCoeff() >= -1e-7 * (1 + multipliers.maxCoeff()));
    left_over -= active * multipliers;
  }
  RC_ASSERT(left_over.norm() <= 1e-8 * (q.g.norm() + q.H.norm() * y->norm()));
}

TEST(QuadraticMinimum, without_conditions_solves_the_linear_system) {
  const auto y = quadratic_minimum(2 * Matrix2d::Identity(), Vector2d(-2, 4),
                                   MatrixXd(0, 2), VectorXd());
  ASSERT_TRUE(y.has_value());
  EXPECT_LT((*y - Vector2d(1, -2)).norm(), 1e-15);
}

TEST(QuadraticMinimum, is_nothing_where_the_conditions_contradict_each_other) {
  const Vector2d up(1, -1), limits(1, 1);  // y >= 1 and y <= -1
  EXPECT_FALSE(
      quadratic_minimum(MatrixXd::Identity(1, 1), VectorXd::Zero(1), up, limits)
          .has_value());
}

TEST(QuadraticMinimum, is_nothing_where_the_form_is_not_positive_definite) {
  const Matrix2d H = Vector2d(1, -1).asDiagonal();
  EXPECT_FALSE(
      quadratic_minimum(H, Vector2d::Zero(), MatrixXd(0, 2), VectorXd())
          .has_value());
}

/// A condition that y hardly changes has terms that are large against what y does to it;
/// the others are met to their own.
TEST(QuadraticMinimum, meets_conditions_beside_one_that_hardly_changes) {
  const MatrixXd H = MatrixXd::Identity(1, 1),
                 C = (MatrixXd(2, 1) << -1, 1e-15).finished();
  const auto y =
      quadratic_minimum(H, VectorXd::Constant(1, -2), C, Vector2d(-1, -1));
  ASSERT_TRUE(y.has_value());
  EXPECT_NEAR((*y)[0], 1, 1e-14);
}

/// With its minimum at y, where all conditions meet.
Quadratic with_corner(Quadratic q, const VectorXd& y, const MatrixXd& C,
                      double push, Random& random) {
  q.C = C;
  q.d = C * y;
  q.g = push * C.transpose() *
            random_vector(static_cast<int>(C.rows()), random).cwiseAbs() -
        q.H * y;
  return q;
}

/// Chords of friction cones in three of the unknowns' combinations each.
MatrixXd chords(int cones, int unknowns, double friction, Random& random) {
  constexpr int sides = 8;
  MatrixXd rows(sides * cones, unknowns);
  for (int cone = 0; cone < cones; ++cone) {
    const MatrixXd P = random_matrix(3, unknowns, random);
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * EIGEN_PI * k / sides;
      rows.row(sides * cone + k) =
          -Eigen::RowVector3d(friction, std::cos(angle), std::sin(angle)) * P;
    }
  }
  return rows;
}

RC_GTEST_PROP(QuadraticMinimum, is_found_where_too_many_conditions_nearly_meet,
              (Random random)) {
  constexpr double apart = 1e-13;
  const int unknowns = 6;
  Quadratic q = random_quadratic(unknowns, 1, random);
  const VectorXd stiffer = (3 * random_vector(unknowns, random)).array().exp();
  q.H = stiffer.asDiagonal() * q.H * stiffer.asDiagonal();
  const VectorXd y = random_vector(unknowns, random);
  q = with_corner(q, y, chords(6, unknowns, 0.3, random), 0.3, random);
  q.d += apart * random_vector(48, random);
  const auto found = quadratic_minimum(q.H, q.g, q.C, q.d);
  RC_ASSERT(found.has_value());
  RC_ASSERT(q.violation(*found) < 100 * apart);
  RC_ASSERT(std::abs(q.value(*found) - q.value(y)) <
            100 * apart * (1 + q.g.norm() * y.norm()));
}

RC_GTEST_PROP(QuadraticMinimum, meets_conditions_far_from_the_free_minimum,
              (Random random)) {
  const VectorXd y = random_vector(4, random);
  const MatrixXd C =
      MatrixXd::Identity(3, 4) + 0.2 * random_matrix(3, 4, random);
  const Quadratic q =
      with_corner(random_quadratic(4, 1, random), y, C, 1e7, random);
  const auto found = quadratic_minimum(q.H, q.g, q.C, q.d);
  RC_ASSERT(found.has_value());
  RC_ASSERT(q.violation(*found) < 1e-13 * (1 + found->norm()));
}

}  // namespace
}  // namespace ffcontact
