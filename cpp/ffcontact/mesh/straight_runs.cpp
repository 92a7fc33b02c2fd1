// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/straight_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ffcontact/base/plane.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Coarser coordinates, in parts of the body's size, were typed, not rounded.
constexpr double coarsest_rounding = 2e-5;

/// Decimals before the point of a number: |x| < 10^decimals.
int decimals_before_point(double x) {
  return static_cast<int>(std::floor(std::log10(std::abs(x)))) + 1;
}

/// Significant decimals of a number that is known to `tolerance`; at most `most`.
int significant_decimals(double x, double tolerance, int most) {
  if (std::abs(x) <= tolerance) return 0;
  const int before = decimals_before_point(x);
  for (int count = 1; count < most; ++count) {
    const double unit = std::pow(10.0, before - count);
    if (unit <= tolerance) return most;
    if (std::abs(x - std::rint(x / unit) * unit) <= tolerance) return count;
  }
  return most;
}

/// By all coordinates, at most `most`.
int decimals_needed(const Ref<const Matrix2Xd>& points, double tolerance,
                    int most) {
  int decimals = 0;
  for (const double x : points.reshaped())
    if (decimals < most)
      decimals = std::max(decimals, significant_decimals(x, tolerance, most));
  return decimals;
}

/// The directions from a point to others that a straight line through it may have: those
/// within half an angle of the middle.
class Sleeve {
 public:
  Sleeve(const Vector2d& first, double tolerance)
      : first_(first), tolerance_(tolerance) {}

  /// Whether the next point of a chain is on a line with all before; it is then one of
  /// them.
  bool takes(const Vector2d& point) {
    const Vector2d d = point - first_;
    const double distance = d.norm();
    if (!(distance > farthest_ - tolerance_)) return false;
    farthest_ = std::max(farthest_, distance);
    if (distance <= 2 * tolerance_) return true;
    if (axis_.isZero(0)) axis_ = d / distance;
    const double along = axis_.dot(d);
    return along > 0 && narrows_to(std::atan2(cross(axis_, d), along),
                                   std::asin(tolerance_ / distance));
  }

 private:
  /// Whether an angle is inside; what is farther from it than `half` then no longer is.
  bool narrows_to(double angle, double half) {
    if (angle < lowest_ || angle > highest_) return false;
    lowest_ = std::max(lowest_, angle - half);
    highest_ = std::min(highest_, angle + half);
    return true;
  }

  const Vector2d first_;
  const double tolerance_;
  Vector2d axis_ = Vector2d::Zero();  ///< angles are measured from it
  double farthest_ = 0;
  double lowest_ = -infinity, highest_ = infinity;
};

/// The last point of a chain on a straight line from `start`.
int end_of_run(const Ref<const Matrix2Xd>& chain, int start, double tolerance) {
  Sleeve sleeve(chain.col(start), tolerance);
  int end = start + 1;
  sleeve.takes(chain.col(end));
  while (end + 1 < chain.cols() && sleeve.takes(chain.col(end + 1))) ++end;
  return end;
}

}  // namespace

double coordinate_precision(const Ref<const Matrix2Xd>& points, double size) {
  constexpr int all = 16;
  const double largest = max_norm(points);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * largest;
  const int decimals = decimals_needed(points, rounding, all);
  if (decimals == 0 || decimals == all) return rounding;
  const double unit = std::pow(10.0, decimals_before_point(largest) - decimals);
  return unit > coarsest_rounding * size ? rounding : std::max(unit, rounding);
}

std::vector<int> straight_runs(const Ref<const Matrix2Xd>& chain,
                               double tolerance) {
  const int last = static_cast<int>(chain.cols()) - 1;
  std::vector<int> starts;
  for (int start = 0; start < last; start = end_of_run(chain, start, tolerance))
    starts.push_back(start);
  starts.push_back(last);
  return starts;
}

double extent(const Ref<const Matrix2Xd>& points) {
  return box_sides(points).norm();
}

}  // namespace ffcontact
