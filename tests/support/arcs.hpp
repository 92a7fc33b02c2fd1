// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "support/meshes.hpp"

/// Bodies that are bounded by circles.
namespace ffcontact::test {

/// Part of a ring about the origin whose side `bottom` is an arc of this radius, with
/// vertices at these ascending angles from (0, -1) [rad]; a disc but for its middle half.
inline Mesh arc_body(const std::vector<double>& angles, double radius) {
  const int n = static_cast<int>(angles.size()) - 1;
  Mesh mesh = rectangle(n, 2, n, 2);
  for (auto x : mesh.vertices.colwise()) {
    const double angle = angles[std::lround(x[0])],
                 r = radius * (1 - 0.25 * x[1]);
    x << r * std::sin(angle), -r * std::cos(angle);
  }
  return mesh;
}

/// The same turned inside out: `bottom` is hollow.
inline Mesh hollow_body(const std::vector<double>& angles, double radius) {
  Mesh mesh = arc_body({angles.rbegin(), angles.rend()}, radius);
  for (auto x : mesh.vertices.colwise()) {
    const double r = x.norm();
    x *= (2 * radius - r) / r;
  }
  return mesh;
}

/// n edges of one length.
inline std::vector<double> even_angles(double from, double to, int n) {
  std::vector<double> angles;
  for (int k = 0; k <= n; ++k) angles.push_back(from + k * (to - from) / n);
  return angles;
}

}  // namespace ffcontact::test
