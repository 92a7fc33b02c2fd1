// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// The quadrature of degree 5 that FreeFEM's int1d and int2d use by default on boundary
/// facets: three points of Gauss on an edge, seven of Radon on a triangle.
template <int d>
struct FacetQuadrature;

template <>
struct FacetQuadrature<2> {
  static constexpr int points = 3;
  static constexpr double weights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

  /// The hat functions of the vertices, (1 -+ sqrt(3/5)) / 2.
  static Vector2d hats(int point) {
    constexpr double places[] = {0.1127016653792583, 0.5, 0.8872983346207417};
    return {1 - places[point], places[point]};
  }
};

template <>
struct FacetQuadrature<3> {
  static constexpr int points = 7;
  /// 9 / 40, (155 -+ sqrt(15)) / 1200
  static constexpr double near = 0.1259391805448271, far = 0.1323941527885062,
                          weights[] = {0.225, near, near, near, far, far, far};

  /// 1 / 3, and (6 -+ sqrt(15)) / 21 at all vertices but one.
  static Vector3d hats(int point) {
    constexpr double places[] = {0.1012865073234563, 0.4701420641051151};
    if (point == 0) return Vector3d::Constant(1.0 / 3);
    const double place = places[(point - 1) / 3];
    Vector3d hats = Vector3d::Constant(place);
    hats[(point - 1) % 3] = 1 - 2 * place;
    return hats;
  }
};

}  // namespace ffcontact
