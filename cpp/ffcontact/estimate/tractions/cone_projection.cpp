// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/cone_projection.hpp"

#include <cmath>
#include <vector>

#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// One side of the polygon, from a corner on.
struct ConeSide {
  Vector2d corner, direction;  ///< of length 1
  double length;
};

std::vector<ConeSide> sides_of(const FrictionCone& cone) {
  const double top = std::min(cone.cohesion, cone.limit);
  const Vector2d outward(-1, 0),
      along = Vector2d(-1, cone.friction).normalized();
  std::vector<ConeSide> sides{{{0, 0}, {0, 1}, top}};
  const bool is_limited = cone.limit < infinity && cone.friction > 0;
  if (!is_limited || cone.limit <= top) {
    sides.push_back({{0, top}, cone.limit <= top ? outward : along, infinity});
    return sides;
  }
  const double rise = cone.limit - cone.cohesion, length = rise / along.y();
  const Vector2d corner(-rise / cone.friction, cone.limit);
  sides.push_back({{0, top}, along, length});
  sides.push_back({corner, outward, infinity});
  return sides;
}

struct PlaneProjection {
  Vector2d point;
  Matrix2d slope;
};

PlaneProjection nearest_on(const ConeSide& side, const Vector2d& r) {
  const double at = side.direction.dot(r - side.corner);
  if (at <= 0) return {side.corner, Matrix2d::Zero()};
  if (at >= side.length)
    return {side.corner + side.length * side.direction, Matrix2d::Zero()};
  return {side.corner + at * side.direction,
          side.direction * side.direction.transpose()};
}

PlaneProjection in_half_plane(const FrictionCone& cone, const Vector2d& r) {
  if (r[0] <= 0 && r[1] <= cone.bound(r[0])) return {r, Matrix2d::Identity()};
  PlaneProjection nearest;
  double least = infinity;
  for (const ConeSide& side : sides_of(cone)) {
    const PlaneProjection on_side = nearest_on(side, r);
    const double distance = (on_side.point - r).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = on_side;
  }
  // to the last digit
  nearest.point[1] = std::min(nearest.point[1], cone.bound(nearest.point[0]));
  return nearest;
}

}  // namespace

ConeProjection cone_projection(const FrictionCone& cone, const Vector3d& r) {
  if (cone.bonded) return {r, Matrix3d::Identity()};
  const double size = r.tail<2>().norm();
  const auto [point, slope] = in_half_plane(cone, {r[0], size});
  if (size == 0) {
    const Vector3d diagonal(slope(0, 0), slope(1, 1), slope(1, 1));
    return {{point[0], 0, 0}, diagonal.asDiagonal()};
  }
  const Vector2d along = r.tail<2>() / size;
  const double ratio = point[1] / size;
  ConeProjection result;
  result.point << point[0], ratio * r.tail<2>();
  result.slope << slope(0, 0), slope(0, 1) * along.transpose(),
      slope(1, 0) * along,
      ratio * Matrix2d::Identity() +
          (slope(1, 1) - ratio) * along * along.transpose();
  return result;
}

}  // namespace ffcontact
