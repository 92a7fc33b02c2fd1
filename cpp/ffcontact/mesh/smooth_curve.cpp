// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/smooth_curve.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "ffcontact/base/plane.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/mesh/turns.hpp"

namespace ffcontact {

namespace {

template <int dim>
using PointsOf = Matrix<double, dim, Dynamic>;

/// On a circle the tangents at both ends of a chord make the same angle with it.
template <class Vector>
Vector mirrored(const Vector& tangent, const Vector& chord) {
  return 2 * chord.dot(tangent) / chord.squaredNorm() * chord - tangent;
}

/// Where (point - x(s)) . t(s) = 0 on a chord, s in [0, 1] but for rounding.
template <int dim>
std::optional<double> foot(const VectorOf<dim>& point,
                           const Chord<dim>& chord) {
  constexpr double rounding = 1e-9;
  const VectorOf<dim> r = point - chord.first;
  const VectorOf<dim> m = chord.last_tangent - chord.first_tangent;
  const auto s = finite_root(r.dot(chord.first_tangent),
                             r.dot(m) - chord.vector.dot(chord.first_tangent),
                             -chord.vector.dot(m));
  if (!s || !(*s >= -rounding && *s <= 1 + rounding)) return std::nullopt;
  return std::min(1.0, std::max(0.0, *s));
}

template <int dim>
VectorOf<dim> nearer_end(const PointsOf<dim>& points,
                         const VectorOf<dim>& point) {
  const VectorOf<dim> first = points.col(0),
                      last = points.col(points.cols() - 1);
  return (point - first).norm() < (point - last).norm() ? first : last;
}

/// The tangents of a curve while they are found.
template <int dim>
class Tangents {
 public:
  Tangents(const Ref<const PointsOf<dim>>& points, bool closed)
      : turns_(points), closed_(closed) {}

  VectorOf<dim> at(Index k) const {
    if (is_inner(k)) return inner(k);
    const Index beside = k == 0 ? 1 : k - 1;
    const VectorOf<dim> chord = turns_.edge(std::min(k, beside));
    return turned(mirrored(inner(beside), chord), beside, chord.squaredNorm());
  }

 private:
  bool is_inner(Index k) const {
    return closed_ || (k > 0 && k < turns_.edges());
  }

  VectorOf<dim> inner(Index k) const {
    const VectorOf<dim> a = turns_.edge(k - 1), b = turns_.edge(k);
    return turned((a / a.squaredNorm() + b / b.squaredNorm()).normalized(), k,
                  -a.norm() * b.norm());
  }

  /// By kappa' / 6 times a square of lengths, in the plane.
  VectorOf<dim> turned(const VectorOf<dim>& tangent, Index k,
                       double square) const {
    if constexpr (dim > 2)
      return tangent;
    else
      return Eigen::Rotation2Dd(slope(k) * square / 6) * tangent;
  }

  /// kappa' at an inner point.
  double slope(Index k) const {
    const Index before = is_inner(k - 1) ? k - 1 : k,
                after = is_inner(k + 1) ? k + 1 : k;
    if (before == after) return 0;
    double way = 0;  // between the means of the points of both circles
    for (Index j = before; j < after; ++j)
      way +=
          (turns_.length(j - 1) + turns_.length(j) + turns_.length(j + 1)) / 3;
    return (circle_curvature(after) - circle_curvature(before)) / way;
  }

  /// Of the circle through an inner point and its neighbours; positive to the left.
  double circle_curvature(Index k) const {
    const Vector2d a = turns_.edge(k - 1), b = turns_.edge(k);
    return 2 * cross(a, b) / (a.norm() * b.norm() * (a + b).norm());
  }

  const Turns<dim> turns_;
  const bool closed_;
};

}  // namespace

template <int dim>
VectorOf<dim> Chord<dim>::curve_at(double s) const {
  const double theta = angle_between(first_tangent, last_tangent),
               quarter = std::cos(theta / 4);
  const double length = vector.norm() / (quarter * quarter);
  const VectorOf<dim> bend = (1 - s) * first_tangent - s * last_tangent;
  return first + s * s * (3 - 2 * s) * vector + s * (1 - s) * length * bend;
}

template <int dim>
Chord<dim> SmoothCurve<dim>::chord(int piece) const {
  const Point first = points.col(piece);
  return {first, points.col(piece + 1) - first, tangents.col(piece),
          tangents.col(piece + 1)};
}

template <int dim>
VectorOf<dim> SmoothCurve<dim>::beside(const Point& point) const {
  Point best = nearer_end<dim>(points, point);
  double distance = infinity;
  for (int piece = 0; piece < pieces(); ++piece) {
    const Chord<dim> chord = this->chord(piece);
    const auto s = foot<dim>(point, chord);
    if (!s) continue;
    const double off = (point - chord.first - *s * chord.vector).norm();
    if (off >= distance) continue;
    distance = off;
    best = chord.curve_at(*s);
  }
  return best;
}

template <int dim>
SmoothCurve<dim> smooth_curve(
    const Ref<const typename SmoothCurve<dim>::Points>& points, bool closed,
    const EndTangents<dim>& ends) {
  SmoothCurve<dim> curve{points, PointsOf<dim>(dim, points.cols())};
  const Tangents<dim> tangents(points, closed);
  const Index last = points.cols() - 1;
  for (Index k = 0; k <= last; ++k) curve.tangents.col(k) = tangents.at(k);
  if (ends.first) curve.tangents.col(0) = *ends.first;
  if (ends.last) curve.tangents.col(last) = *ends.last;
  return curve;
}

template struct SmoothCurve<FFCONTACT_DIMENSION>;
template struct Chord<FFCONTACT_DIMENSION>;
template SmoothCurve<FFCONTACT_DIMENSION> smooth_curve<FFCONTACT_DIMENSION>(
    const Ref<const Matrix<double, FFCONTACT_DIMENSION, Dynamic>>&, bool,
    const EndTangents<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
