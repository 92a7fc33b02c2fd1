// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Between two neighbouring points of a curve.
template <int dim>
struct Chord {
  VectorOf<dim> first, vector;
  VectorOf<dim> first_tangent, last_tangent;  ///< of the curve at its ends

  /// The point of the curve at s in [0, 1].
  VectorOf<dim> curve_at(double s) const;
};

/// A smooth curve through given points, for boundaries of which a mesh knows the vertices
/// only; in the plane or in space.
///
/// The tangent at a point is that of the circle through it and its neighbours,
///     t_i ~ a/|a|^2 + b/|b|^2,   a = x_i - x_(i-1),  b = x_(i+1) - x_i;
/// in the plane turned by -kappa' |a| |b| / 6, what it is off by where the curvature kappa
/// changes along the curve: kappa' is the slope between the circles of both neighbours, at
/// the mean abscissae of their points. At an end the tangent is mirrored on the chord, in
/// the plane with kappa' |c|^2 / 6 more, or a given one. The tangents are then of third
/// order, and exact on circles.
///
/// Between neighbours the curve is Hermite's cubic with tangent vectors of length
/// c/cos^2(theta/4), c the chord and theta the angle between the tangents: points of a
/// circle of radius R give the circle to within 4e-5 theta^6 R.
template <int dim>
struct SmoothCurve {
  using Point = VectorOf<dim>;
  using Points = Matrix<double, dim, Dynamic>;

  Points points;    ///< in order; the first again at the end of a closed curve
  Points tangents;  ///< unit vectors

  int pieces() const { return static_cast<int>(points.cols()) - 1; }
  Chord<dim> chord(int piece) const;
  /// The point of the curve beside a point: on the same normal of the chords, tangents
  /// being interpolated.
  Point beside(const Point& point) const;
};

/// Tangents that are known at the ends of a curve, of length 1.
template <int dim>
struct EndTangents {
  std::optional<VectorOf<dim>> first, last;
};

/// @param points  at least three; the first again at the end of a closed curve
template <int dim = 2>
SmoothCurve<dim> smooth_curve(
    const Ref<const typename SmoothCurve<dim>::Points>& points, bool closed,
    const EndTangents<dim>& ends = {});

}  // namespace ffcontact
