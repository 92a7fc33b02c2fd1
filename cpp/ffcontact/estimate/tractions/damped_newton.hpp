// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

/// Newton's method for the dual of nearest_in_cone, a convex function of eta that is
/// quadratic in pieces (plane) or smooth in pieces (space), damped after Levenberg and
/// Marquardt. A Dual has Point{eta, off, ...} with the gradient off, point_at(eta) and
/// slope(point), d off / d eta.
template <class Dual>
class DampedNewton {
 public:
  using Point = typename Dual::Point;

  /// @param size   of the slope where no condition of the cone is tight: lengths or areas of
  ///               the line or surface, as [z] is of size 1
  /// @param scale  of the terms of the gradient
  DampedNewton(const Dual& dual, double size, double scale)
      : dual_(dual), size_(size), scale_(scale > 0 ? scale : 1) {}

  /// The next point. Regularised by what is left to do: the last steps are Newton's, the
  /// first one is no longer than the tractions. Ten times less after each step of full
  /// length, so that tractions far larger than the given ones, which wedge a body between
  /// two parts of its line, are found in as few steps as others; four times more after a
  /// shortened one.
  Point after(const Point& from) {
    const VectorXd step = newton_step(from);
    double length = 1;
    Point next = dual_.point_at(from.eta + step);
    while (too_far(next, from, step) && length > 1e-10) {
      length /= 2;
      next = dual_.point_at(from.eta + length * step);
    }
    damping_ = length < 1 ? std::min(1.0, 4 * damping_)
                          : std::max(least_damping, 0.1 * damping_);
    return next;
  }

 private:
  static constexpr double least_damping = 1e-12;

  VectorXd newton_step(const Point& point) const {
    const double regular = damping_ * size_ * max_norm(point.off) / scale_;
    MatrixXd slope = dual_.slope(point);
    slope.diagonal().array() += regular;
    const Cholesky factor(slope);
    return -(factor.is_positive_definite() ? factor.solve(point.off)
                                           : least_squares(slope, point.off));
  }

  /// The gradient along the step has changed its sign by more than a little, and has not
  /// halved.
  static bool too_far(const Point& next, const Point& from,
                      const VectorXd& step) {
    return next.off.dot(step) > -0.1 * from.off.dot(step) &&
           next.off.norm() > 0.5 * from.off.norm();
  }

  const Dual& dual_;
  double size_, scale_, damping_ = 1;
};

}  // namespace ffcontact
