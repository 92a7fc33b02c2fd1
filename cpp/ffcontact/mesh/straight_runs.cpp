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

/// Angles by which a chain turns at its inner points, and 0 at its ends.
VectorXd turns_of(const Ref<const Matrix2Xd>& chain) {
  VectorXd turn = VectorXd::Zero(chain.cols());
  for (Index k = 1; k + 1 < chain.cols(); ++k)
    turn[k] = turn_at(chain, k - 1, k, k + 1);
  return turn;
}

/// Whether a chain has a corner at a point, seen from the curvature of the neighbours
/// that it turns at as well.
bool sticks_out(const Ref<const Matrix2Xd>& chain, const VectorXd& turn,
                int k) {
  constexpr double smallest = 2 * M_PI / 180, times = 4;
  const auto reach = [&](int i) {
    return 0.5 * ((chain.col(i + 1) - chain.col(i)).norm() +
                  (chain.col(i) - chain.col(i - 1)).norm());
  };
  double curvature = 0;
  for (const int i : {k - 1, k + 1})
    if (i > 0 && i + 1 < chain.cols())
      curvature = std::max(curvature, turn[i] / reach(i));
  return turn[k] > std::max(smallest, times * curvature * reach(k));
}

/// The single edges from run r on that turn as one curve does end with the run before
/// this one.
std::size_t end_of_curve(const Ref<const Matrix2Xd>& chain,
                         const VectorXd& turn, const std::vector<int>& runs,
                         double corner, std::size_t r) {
  const auto is_single = [&](std::size_t k) {
    return runs[k + 1] - runs[k] == 1;
  };
  std::size_t end = r + 1;
  if (!is_single(r)) return end;
  while (end + 1 < runs.size() && is_single(end) && turn[runs[end]] < corner &&
         !sticks_out(chain, turn, runs[end]))
    ++end;
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

std::vector<LinePart> line_parts(const Ref<const Matrix2Xd>& chain,
                                 double tolerance, double corner, int fewest) {
  const std::vector<int> runs = straight_runs(chain, tolerance);
  const VectorXd turn = turns_of(chain);
  std::vector<LinePart> parts;
  for (std::size_t r = 0; r + 1 < runs.size();) {
    const std::size_t end = end_of_curve(chain, turn, runs, corner, r);
    const bool curve = static_cast<int>(end - r) >= fewest;
    if (curve) parts.push_back({runs[r], runs[end], false});
    for (; r < end; ++r)
      if (!curve) parts.push_back({runs[r], runs[r + 1], true});
  }
  return parts;
}

double angle_between(const Vector2d& a, const Vector2d& b) {
  return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

double turn_at(const Ref<const Matrix2Xd>& points, Index before, Index at,
               Index after) {
  return angle_between(points.col(at) - points.col(before),
                       points.col(after) - points.col(at));
}

double extent(const Ref<const Matrix2Xd>& points) {
  return box_sides(points).norm();
}

}  // namespace ffcontact
