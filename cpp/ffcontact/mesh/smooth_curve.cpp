// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/smooth_curve.hpp"

#include <cmath>
#include <limits>
#include <optional>

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

/// Where (point - x(s)) . t(s) = 0 on a chord, s in [0, 1] but for rounding.
std::optional<double> foot(const Vector2d& point, const Vector2d& first,
                           const Vector2d& chord, const Vector2d& first_tangent,
                           const Vector2d& last_tangent) {
  constexpr double rounding = 1e-9;
  const Vector2d r = point - first, m = last_tangent - first_tangent;
  const double c0 = r.dot(first_tangent),
               c1 = r.dot(m) - chord.dot(first_tangent), c2 = -chord.dot(m);
  const double root = c1 * c1 - 4 * c0 * c2;
  if (!(root >= 0)) return std::nullopt;
  // the root that stays finite as c2 -> 0
  const double s = -2 * c0 / (c1 + (c1 < 0 ? -1 : 1) * std::sqrt(root));
  if (!(s >= -rounding && s <= 1 + rounding)) return std::nullopt;
  return std::min(1.0, std::max(0.0, s));
}

}  // namespace

Vector2d SmoothCurve::at(int piece, double s) const {
  const Vector2d first = points.col(piece),
                 chord = points.col(piece + 1) - first;
  const double quarter =
      std::cos(angle_between(tangents.col(piece), tangents.col(piece + 1)) / 4);
  const double length = chord.norm() / (quarter * quarter);
  return first + s * s * (3 - 2 * s) * chord +
         s * (1 - s) * length *
             ((1 - s) * tangents.col(piece) - s * tangents.col(piece + 1));
}

Vector2d SmoothCurve::beside(const Vector2d& point) const {
  const bool at_first =
      (point - points.col(0)).norm() < (point - points.col(pieces())).norm();
  Vector2d best = points.col(at_first ? 0 : pieces());
  double distance = std::numeric_limits<double>::infinity();
  for (int piece = 0; piece < pieces(); ++piece) {
    const Vector2d chord = points.col(piece + 1) - points.col(piece);
    const auto s = foot(point, points.col(piece), chord, tangents.col(piece),
                        tangents.col(piece + 1));
    if (!s) continue;
    const double off = (point - points.col(piece) - *s * chord).norm();
    if (off >= distance) continue;
    distance = off;
    best = at(piece, *s);
  }
  return best;
}

bool closes_smoothly(const Ref<const Matrix2Xd>& points) {
  const Index n = points.cols() - 1;
  const auto turn = [&](Index before, Index at, Index after) {
    return angle_between(points.col(at) - points.col(before),
                         points.col(after) - points.col(at));
  };
  return turn(n - 1, 0, 1) <=
         2 * std::max(turn(0, 1, 2), turn(n - 2, n - 1, n));
}

SmoothCurve smooth_curve(const Ref<const Matrix2Xd>& points, bool closed) {
  const Index last = points.cols() - 1;
  SmoothCurve curve{points, Matrix2Xd(2, points.cols())};
  for (Index k = 1; k < last; ++k)
    curve.tangents.col(k) =
        circle_tangent(points.col(k - 1), points.col(k), points.col(k + 1));
  if (closed) {
    curve.tangents.col(0) = curve.tangents.col(last) =
        circle_tangent(points.col(last - 1), points.col(0), points.col(1));
  } else {
    curve.tangents.col(0) =
        mirrored(curve.tangents.col(1), points.col(1) - points.col(0));
    curve.tangents.col(last) = mirrored(
        curve.tangents.col(last - 1), points.col(last) - points.col(last - 1));
  }
  return curve;
}

}  // namespace ffcontact
