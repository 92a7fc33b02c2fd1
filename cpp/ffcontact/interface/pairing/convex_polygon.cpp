// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/convex_polygon.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/plane.hpp"

namespace ffcontact {

namespace {

/// The half-plane on the left of the way from p to q.
struct HalfPlane {
  Vector2d p, q;
  /// Twice the area of (p, q, x), positive inside.
  double height(const Vector2d& x) const { return cross(q - p, x - p); }
};

HalfPlane side(const ConvexPolygon& polygon, Index k) {
  return {polygon.col(k), polygon.col((k + 1) % polygon.cols())};
}

HalfPlane turned(const HalfPlane& half) { return {half.q, half.p}; }

/// What is left of a polygon in a half-plane [Sutherland, Hodgman 1974].
ConvexPolygon clipped(const ConvexPolygon& polygon, const HalfPlane& half) {
  std::vector<Vector2d> corners;
  for (Index k = 0; k < polygon.cols(); ++k) {
    const HalfPlane way = side(polygon, k);
    const double at = half.height(way.p), next = half.height(way.q);
    if (at >= 0) corners.emplace_back(way.p);
    if ((at > 0 && next < 0) || (at < 0 && next > 0))
      corners.emplace_back(between(way.p, way.q, at / (at - next)));
  }
  return packed(corners);
}

}  // namespace

double polygon_area(const ConvexPolygon& polygon) {
  double twice = 0;
  for (Index k = 2; k < polygon.cols(); ++k)
    twice += cross(polygon.col(k - 1) - polygon.col(0),
                   polygon.col(k) - polygon.col(0));
  return 0.5 * twice;
}

ConvexPolygon intersection(const ConvexPolygon& a, const ConvexPolygon& b) {
  ConvexPolygon left = a;
  for (Index k = 0; k < b.cols() && left.cols() > 0; ++k)
    left = clipped(left, side(b, k));
  return b.cols() > 0 ? left : b;
}

std::vector<ConvexPolygon> difference(const ConvexPolygon& a,
                                      const ConvexPolygon& b) {
  std::vector<ConvexPolygon> pieces;
  ConvexPolygon left = a;
  for (Index k = 0; k < b.cols() && left.cols() > 0; ++k) {
    ConvexPolygon beyond = clipped(left, turned(side(b, k)));
    if (polygon_area(beyond) > 0) pieces.push_back(std::move(beyond));
    left = clipped(left, side(b, k));
  }
  if (b.cols() == 0) pieces.push_back(a);
  return pieces;
}

}  // namespace ffcontact
