// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/smooth_curve.hpp"

#include <cmath>
#include <optional>

#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/plane.hpp"
#include "ffcontact/mesh/straight_runs.hpp"

namespace ffcontact {

namespace {

Vector2d circle_tangent(const Vector2d& before, const Vector2d& at,
                        const Vector2d& after) {
  const Vector2d a = at - before, b = after - at;
  return (a / a.squaredNorm() + b / b.squaredNorm()).normalized();
}

/// On a circle the tangents at both ends of a chord make the same angle with it.
Vector2d mirrored(const Vector2d& tangent, const Vector2d& chord) {
  return 2 * chord.dot(tangent) / chord.squaredNorm() * chord - tangent;
}

/// Between two neighbouring points of a curve.
struct Chord {
  Vector2d first, vector;
  Vector2d first_tangent, last_tangent;  ///< of the curve at its ends
};

Chord chord_of(const SmoothCurve& curve, int piece) {
  const Vector2d first = curve.points.col(piece);
  return {first, curve.points.col(piece + 1) - first, curve.tangents.col(piece),
          curve.tangents.col(piece + 1)};
}

/// Where (point - x(s)) . t(s) = 0 on a chord, s in [0, 1] but for rounding.
std::optional<double> foot(const Vector2d& point, const Chord& chord) {
  constexpr double rounding = 1e-9;
  const Vector2d r = point - chord.first;
  const Vector2d m = chord.last_tangent - chord.first_tangent;
  const auto s = finite_root(r.dot(chord.first_tangent),
                             r.dot(m) - chord.vector.dot(chord.first_tangent),
                             -chord.vector.dot(m));
  if (!s || !(*s >= -rounding && *s <= 1 + rounding)) return std::nullopt;
  return std::min(1.0, std::max(0.0, *s));
}

Vector2d nearer_end(const Matrix2Xd& points, const Vector2d& point) {
  const Vector2d first = points.col(0), last = points.col(points.cols() - 1);
  return (point - first).norm() < (point - last).norm() ? first : last;
}

void put_end_tangents(bool closed, SmoothCurve& curve) {
  const Matrix2Xd& x = curve.points;
  Matrix2Xd& t = curve.tangents;
  const Index last = x.cols() - 1;
  if (closed) {
    t.col(0) = t.col(last) =
        circle_tangent(x.col(last - 1), x.col(0), x.col(1));
    return;
  }
  t.col(0) = mirrored(t.col(1), x.col(1) - x.col(0));
  t.col(last) = mirrored(t.col(last - 1), x.col(last) - x.col(last - 1));
}

}  // namespace

Vector2d SmoothCurve::at(int piece, double s) const {
  const Chord chord = chord_of(*this, piece);
  const double theta = angle_between(chord.first_tangent, chord.last_tangent),
               quarter = std::cos(theta / 4);
  const double length = chord.vector.norm() / (quarter * quarter);
  const Vector2d bend = (1 - s) * chord.first_tangent - s * chord.last_tangent;
  return chord.first + s * s * (3 - 2 * s) * chord.vector +
         s * (1 - s) * length * bend;
}

Vector2d SmoothCurve::beside(const Vector2d& point) const {
  Vector2d best = nearer_end(points, point);
  double distance = infinity;
  for (int piece = 0; piece < pieces(); ++piece) {
    const Chord chord = chord_of(*this, piece);
    const auto s = foot(point, chord);
    if (!s) continue;
    const double off = (point - chord.first - *s * chord.vector).norm();
    if (off >= distance) continue;
    distance = off;
    best = at(piece, *s);
  }
  return best;
}

bool closes_smoothly(const Ref<const Matrix2Xd>& points) {
  const Index n = points.cols() - 1;
  const double beside =
      std::max(turn_at(points, 0, 1, 2), turn_at(points, n - 2, n - 1, n));
  return turn_at(points, n - 1, 0, 1) <= 2 * beside;
}

SmoothCurve smooth_curve(const Ref<const Matrix2Xd>& points, bool closed) {
  SmoothCurve curve{points, Matrix2Xd(2, points.cols())};
  for (Index k = 1; k + 1 < points.cols(); ++k)
    curve.tangents.col(k) =
        circle_tangent(points.col(k - 1), points.col(k), points.col(k + 1));
  put_end_tangents(closed, curve);
  return curve;
}

}  // namespace ffcontact
