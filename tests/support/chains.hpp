// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "ffcontact/base/eigen.hpp"

/// Chains of points in the plane.
namespace ffcontact::test {

inline Matrix2Xd along(const Vector2d& first, const Vector2d& last, int edges) {
  Matrix2Xd points(2, edges + 1);
  for (int k = 0; k <= edges; ++k)
    points.col(k) = first + (last - first) * k / edges;
  return points;
}

inline Matrix2Xd one_after_the_other(const Matrix2Xd& a, const Matrix2Xd& b) {
  Matrix2Xd both(2, a.cols() + b.cols() - 1);
  both << a, b.rightCols(b.cols() - 1);
  return both;
}

/// Part of a circle, from angles [rad] at its lowest point (0, 0) on.
inline Matrix2Xd arc(double radius, double from, double to, int edges) {
  Matrix2Xd points(2, edges + 1);
  for (int k = 0; k <= edges; ++k) {
    const double angle = from + (to - from) * k / edges;
    points.col(k) << radius * std::sin(angle), radius * (1 - std::cos(angle));
  }
  return points;
}

}  // namespace ffcontact::test
