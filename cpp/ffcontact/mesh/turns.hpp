// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/plane.hpp"

namespace ffcontact {

/// Angle between two vectors of the plane or of space [rad].
template <class A, class B>
double angle_between(const Eigen::MatrixBase<A>& a,
                     const Eigen::MatrixBase<B>& b) {
  if constexpr (A::RowsAtCompileTime == 2)
    return std::abs(std::atan2(cross(a, b), a.dot(b)));
  else
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The edges of a chain of points and the angles by which it turns between them; a chain
/// that ends where it begins is a loop, and points count on around it.
template <int dim>
class Turns {
 public:
  using Points = Matrix<double, dim, Dynamic>;

  explicit Turns(const Ref<const Points>& points)
      : points_(points),
        edges_(points.cols() - 1),
        closed_(points.col(0) == points.col(edges_)) {}

  Index edges() const { return edges_; }
  bool is_loop() const { return closed_; }
  /// The number of a point or an edge that may be beyond an end of a loop.
  Index around(Index k) const {
    return closed_ ? (k % edges_ + edges_) % edges_ : k;
  }
  /// Are there an edge before and one after a point?
  bool is_inner(Index k) const { return closed_ || (k > 0 && k < edges_); }
  VectorOf<dim> edge(Index k) const {
    return points_.col(around(k) + 1) - points_.col(around(k));
  }
  double length(Index k) const { return edge(k).norm(); }
  /// At a point [rad]; 0 at the ends of a chain.
  double turn(Index k) const {
    if (!is_inner(k)) return 0;
    return angle_between(edge(k - 1), edge(k));
  }
  /// Half of both edges at an inner point.
  double reach(Index k) const { return 0.5 * (length(k - 1) + length(k)); }
  double curvature(Index k) const {
    return is_inner(k) ? turn(k) / reach(k) : 0;
  }

  /// Does a smooth curve through the points turn as much at an inner one? Up to three
  /// times what the larger curvature at its neighbours makes likely, and 2 degrees.
  bool is_smooth(Index k) const {
    constexpr double times = 3, least = 2 * M_PI / 180;
    const double curvature =
        std::max(this->curvature(k - 1), this->curvature(k + 1));
    return turn(k) <= times * curvature * reach(k) + least;
  }

 private:
  const Points points_;
  const Index edges_;
  const bool closed_;
};

}  // namespace ffcontact
