// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/inner_cone.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ffcontact {

namespace {

constexpr double whole_turn = 2 * EIGEN_PI;
/// Rays nearer to each other than this are one [rad].
constexpr double same_ray = 1e-5;
/// A traction that is larger than this part of its bound may lie outside the chords.
constexpr double near_the_cone = 0.9;

double angle_of(const Vector2d& direction) {
  return std::atan2(direction.y(), direction.x());
}

/// Tractions below this part of the largest have no direction.
constexpr double least_traction = 1e-9;

/// Ascending angles of the rays, the first once more after a turn.
std::vector<double> ray_angles(const FrictionCone& cone,
                               const Vector3d& present,
                               const Vector2d& direction, double largest) {
  const Vector2d rt = present.tail<2>();
  const double first = direction.isZero(0) ? 0 : angle_of(direction);
  std::vector<double> angles;
  for (int k = 0; k < InnerCone::rays; ++k)
    angles.push_back(first + whole_turn * k / InnerCone::rays);
  if (rt.norm() > std::max(near_the_cone * cone.bound(present[0]),
                           least_traction * largest)) {
    double own = angle_of(rt);
    while (own < first - same_ray) own += whole_turn;
    while (own >= first - same_ray + whole_turn) own -= whole_turn;
    const auto next =
        std::find_if(angles.begin(), angles.end(),
                     [&](double angle) { return angle > own - same_ray; });
    if (next != angles.end() && *next < own + same_ray)
      *next = own;
    else
      angles.insert(next, own);
  }
  angles.push_back(angles.front() + whole_turn);
  return angles;
}

}  // namespace

InnerCone inner_cone(const FrictionCone& cone, const Vector3d& present,
                     const Vector2d& direction, double largest) {
  if (cone.bonded) return {{0, 3}, VectorXd(0)};
  InnerCone inner{{InnerCone::most_rows, 3}, VectorXd(InnerCone::most_rows)};
  int rows = 0;
  const auto add = [&](const Vector3d& row, double limit) {
    inner.C.row(rows) = row;
    inner.d[rows++] = std::min(limit, row.dot(present));
  };
  add({-1, 0, 0}, 0);
  if (!cone.frictionless()) {
    const std::vector<double> angles =
        ray_angles(cone, present, direction, largest);
    for (std::size_t k = 1; k < angles.size(); ++k) {
      const double middle = (angles[k - 1] + angles[k]) / 2,
                   chord = std::cos((angles[k] - angles[k - 1]) / 2);
      const Vector3d outward(0, std::cos(middle), std::sin(middle));
      add(Vector3d(-chord * cone.friction, 0, 0) - outward,
          -chord * cone.cohesion);
      if (std::isfinite(cone.limit)) add(-outward, -chord * cone.limit);
    }
  }
  inner.C.conservativeResize(rows, 3);
  inner.d.conservativeResize(rows);
  return inner;
}

}  // namespace ffcontact
