// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/smooth_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/pi.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

Vector2d on_circle(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Angles between 0 and `to` whose steps differ by up to a factor of three.
std::vector<double> uneven_angles(int steps, double to, std::mt19937& random) {
  const Uniform step{1, 3};
  std::vector<double> angles{0};
  for (int k = 0; k < steps; ++k)
    angles.push_back(angles.back() + step(random));
  for (double& angle : angles) angle *= to / angles.back();
  return angles;
}

Matrix2Xd points_at(double radius, const std::vector<double>& angles) {
  Matrix2Xd points(2, static_cast<Index>(angles.size()));
  for (std::size_t k = 0; k < angles.size(); ++k)
    points.col(static_cast<Index>(k)) = on_circle(radius, angles[k]);
  return points;
}

RC_GTEST_PROP(SmoothCurve, through_points_of_a_circle_is_the_circle,
              (Random random)) {
  const std::vector<double> angles = uneven_angles(12, 2, random);
  const SmoothCurve curve = smooth_curve(points_at(50, angles), false);
  double widest = 0;
  for (int k = 0; k < 12; ++k)
    widest = std::max(widest, angles[k + 1] - angles[k]);
  for (std::size_t k = 0; k < angles.size(); ++k)
    RC_ASSERT(curve.tangents.col(static_cast<Index>(k))
                  .dot(on_circle(1, angles[k] + pi / 2)) > 1 - 1e-14);
  for (int piece = 0; piece < 12; ++piece)
    for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0})
      RC_ASSERT(std::abs(curve.chord(piece).curve_at(s).norm() - 50) <
                50 * 4e-5 * std::pow(widest, 6) + 1e-13);
}

RC_GTEST_PROP(SmoothCurve, beside_a_point_is_its_neighbour_on_the_circle,
              (Random random)) {
  const SmoothCurve curve =
      smooth_curve(points_at(50, uneven_angles(40, 2, random)), false);
  const Uniform angle{0, 2}, off{-0.1, 0.1};
  for (int k = 0; k < 20; ++k) {
    const double a = angle(random);
    RC_ASSERT((curve.beside(on_circle(50 + off(random), a)) - on_circle(50, a))
                  .norm() < 0.005);
  }
}

TEST(SmoothCurve, keeps_its_points_and_ends) {
  const Matrix2Xd points = points_at(3, {0, 0.1, 0.3, 0.4});
  const SmoothCurve curve = smooth_curve(points, false);
  for (int k = 0; k < 4; ++k)
    EXPECT_LT((curve.beside(points.col(k)) - points.col(k)).norm(), 1e-14);
  EXPECT_LT((curve.beside(on_circle(3, -0.05)) - points.col(0)).norm(), 1e-14);
  EXPECT_LT((curve.beside(on_circle(3, 0.45)) - points.col(3)).norm(), 1e-14);
}

TEST(SmoothCurve, that_is_closed_has_no_end) {
  std::vector<double> angles;
  for (int k = 0; k <= 16; ++k) angles.push_back(2 * pi * k / 16);
  Matrix2Xd circle = points_at(1, angles);
  circle.col(16) = circle.col(0);
  const SmoothCurve closed = smooth_curve(circle, true);
  EXPECT_LT((closed.tangents.col(0) - Vector2d(0, 1)).norm(), 1e-13);
  EXPECT_EQ(closed.tangents.col(0), closed.tangents.col(16));
  Matrix2Xd ellipse = circle;
  ellipse.row(0) *= 3;
  EXPECT_GT(std::abs(smooth_curve(ellipse, true).tangents(1, 0)), 1 - 1e-12);
  EXPECT_LT(std::abs(smooth_curve(ellipse, false).tangents(1, 0)), 1 - 1e-3);
}

/// The largest angle between the tangents of a curve through uneven points of an ellipse
/// and its own, and the largest distance of the curve from it.
std::pair<double, double> off_an_ellipse(int n, bool closed) {
  const double to = closed ? 2 * pi : 2;
  Matrix2Xd points(2, n + 1);
  VectorXd at(n + 1);
  for (int k = 0; k <= n; ++k) {
    at[k] = to * (k / double(n) + 0.25 / n * std::sin(5.0 * k));
    points.col(k) << 2 * std::cos(at[k]), std::sin(at[k]);
  }
  if (closed) points.col(n) = points.col(0);
  const SmoothCurve<2> curve = smooth_curve(points, closed);
  double angle = 0, beside = 0;
  for (int k = 0; k < n; ++k) {
    const Vector2d tangent(-2 * std::sin(at[k]), std::cos(at[k]));
    angle = std::max(
        angle, std::acos(std::min(
                   1.0, curve.tangents.col(k).dot(tangent.normalized()))));
    const Vector2d middle = curve.chord(k).curve_at(0.5);
    const double phi = std::atan2(middle.y(), middle.x() / 2);
    beside = std::max(
        beside, (middle - Vector2d(2 * std::cos(phi), std::sin(phi))).norm());
  }
  return {angle, beside};
}

TEST(SmoothCurve, has_tangents_of_third_order) {
  for (const bool closed : {true, false}) {
    const auto [coarse_angle, coarse] = off_an_ellipse(48, closed);
    const auto [fine_angle, fine] = off_an_ellipse(192, closed);
    EXPECT_LT(coarse_angle, 4e-3) << closed;
    EXPECT_GT(coarse_angle / fine_angle, std::pow(4, 2.7)) << closed;
    EXPECT_GT(coarse / fine, std::pow(4, 3.5)) << closed;
  }
}

TEST(SmoothCurve, takes_given_tangents_at_its_ends) {
  const Matrix2Xd points = points_at(3, {0, 0.1, 0.3, 0.4});
  const SmoothCurve<2> curve = smooth_curve<2>(
      points, false, {Vector2d(0, 1), std::optional<Vector2d>()});
  EXPECT_EQ(curve.tangents.col(0), Vector2d(0, 1));
  EXPECT_LT((curve.tangents.col(3) - on_circle(1, 0.4 + pi / 2)).norm(), 1e-14);
}

}  // namespace
}  // namespace ffcontact
