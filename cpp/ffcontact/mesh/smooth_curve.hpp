// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// A smooth curve through given points, for boundaries of which a mesh knows the vertices
/// only; in the plane or in space.
///
/// The tangent at a point is that of the circle through it and its neighbours,
///     t_i ~ a/|a|^2 + b/|b|^2,   a = x_i - x_(i-1),  b = x_(i+1) - x_i,
/// at an end that of the circle through the last three points. Between neighbours the
/// curve is Hermite's cubic with tangent vectors of length c/cos^2(theta/4), c the chord
/// and theta the angle between the tangents: points of a circle of radius R give the
/// circle to within 4e-5 theta^6 R.
template <int dim>
struct SmoothCurve {
  using Point = VectorOf<dim>;
  using Points = Matrix<double, dim, Dynamic>;

  Points points;    ///< in order; the first again at the end of a closed curve
  Points tangents;  ///< unit vectors

  int pieces() const { return static_cast<int>(points.cols()) - 1; }
  /// The point of one piece at s in [0, 1].
  Point at(int piece, double s) const;
  /// The point of the curve beside a point: on the same normal of the chords, tangents
  /// being interpolated.
  Point beside(const Point& point) const;
};

/// Whether a chain of points that ends where it begins turns there about as it does
/// beside.
template <int dim = 2>
bool closes_smoothly(
    const Ref<const typename SmoothCurve<dim>::Points>& points);

/// @param points  at least three
template <int dim = 2>
SmoothCurve<dim> smooth_curve(
    const Ref<const typename SmoothCurve<dim>::Points>& points, bool closed);

}  // namespace ffcontact
