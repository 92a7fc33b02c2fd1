// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/smooth_curve.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "ffcontact/base/plane.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/mesh/straight_runs.hpp"

namespace ffcontact {

namespace {

template <int dim>
using PointsOf = Matrix<double, dim, Dynamic>;

template <int dim>
double angle_of(const VectorOf<dim>& a, const VectorOf<dim>& b) {
  if constexpr (dim == 2)
    return angle_between(a, b);
  else
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

template <int dim>
VectorOf<dim> circle_tangent(const Ref<const PointsOf<dim>>& points,
                             Index before, Index at, Index after) {
  const VectorOf<dim> a = points.col(at) - points.col(before),
                      b = points.col(after) - points.col(at);
  return (a / a.squaredNorm() + b / b.squaredNorm()).normalized();
}

/// On a circle the tangents at both ends of a chord make the same angle with it.
template <class Vector>
Vector mirrored(const Vector& tangent, const Vector& chord) {
  return 2 * chord.dot(tangent) / chord.squaredNorm() * chord - tangent;
}

/// Between two neighbouring points of a curve.
template <int dim>
struct Chord {
  VectorOf<dim> first, vector;
  VectorOf<dim> first_tangent, last_tangent;  ///< of the curve at its ends
};

template <int dim>
Chord<dim> chord_of(const SmoothCurve<dim>& curve, int piece) {
  const VectorOf<dim> first = curve.points.col(piece);
  return {first, curve.points.col(piece + 1) - first, curve.tangents.col(piece),
          curve.tangents.col(piece + 1)};
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

template <int dim>
void put_end_tangents(bool closed, SmoothCurve<dim>& curve) {
  const PointsOf<dim>& x = curve.points;
  const Index last = x.cols() - 1;
  const auto tangent = [&](Index k) -> VectorOf<dim> {
    return curve.tangents.col(k);
  };
  const auto chord = [&](Index k) -> VectorOf<dim> {
    return x.col(k + 1) - x.col(k);
  };
  if (closed)
    curve.tangents.col(0) = curve.tangents.col(last) =
        circle_tangent<dim>(x, last - 1, 0, 1);
  else {
    curve.tangents.col(0) = mirrored(tangent(1), chord(0));
    curve.tangents.col(last) = mirrored(tangent(last - 1), chord(last - 1));
  }
}

template <int dim>
double angle_at(const Ref<const PointsOf<dim>>& points, Index before, Index at,
                Index after) {
  const VectorOf<dim> in = points.col(at) - points.col(before),
                      out = points.col(after) - points.col(at);
  return angle_of<dim>(in, out);
}

}  // namespace

template <int dim>
VectorOf<dim> SmoothCurve<dim>::at(int piece, double s) const {
  const Chord<dim> chord = chord_of(*this, piece);
  const double theta = angle_of<dim>(chord.first_tangent, chord.last_tangent),
               quarter = std::cos(theta / 4);
  const double length = chord.vector.norm() / (quarter * quarter);
  const Point bend = (1 - s) * chord.first_tangent - s * chord.last_tangent;
  return chord.first + s * s * (3 - 2 * s) * chord.vector +
         s * (1 - s) * length * bend;
}

template <int dim>
VectorOf<dim> SmoothCurve<dim>::beside(const Point& point) const {
  Point best = nearer_end<dim>(points, point);
  double distance = infinity;
  for (int piece = 0; piece < pieces(); ++piece) {
    const Chord<dim> chord = chord_of(*this, piece);
    const auto s = foot<dim>(point, chord);
    if (!s) continue;
    const double off = (point - chord.first - *s * chord.vector).norm();
    if (off >= distance) continue;
    distance = off;
    best = at(piece, *s);
  }
  return best;
}

template <int dim>
bool closes_smoothly(
    const Ref<const typename SmoothCurve<dim>::Points>& points) {
  const Index n = points.cols() - 1;
  const double beside = std::max(angle_at<dim>(points, 0, 1, 2),
                                 angle_at<dim>(points, n - 2, n - 1, n));
  return angle_at<dim>(points, n - 1, 0, 1) <= 2 * beside;
}

template <int dim>
SmoothCurve<dim> smooth_curve(
    const Ref<const typename SmoothCurve<dim>::Points>& points, bool closed) {
  SmoothCurve<dim> curve{points, PointsOf<dim>(dim, points.cols())};
  for (Index k = 1; k + 1 < points.cols(); ++k)
    curve.tangents.col(k) = circle_tangent<dim>(points, k - 1, k, k + 1);
  put_end_tangents(closed, curve);
  return curve;
}

template struct SmoothCurve<FFCONTACT_DIMENSION>;
template bool closes_smoothly<FFCONTACT_DIMENSION>(
    const Ref<const Matrix<double, FFCONTACT_DIMENSION, Dynamic>>&);
template SmoothCurve<FFCONTACT_DIMENSION> smooth_curve<FFCONTACT_DIMENSION>(
    const Ref<const Matrix<double, FFCONTACT_DIMENSION, Dynamic>>&, bool);

}  // namespace ffcontact
