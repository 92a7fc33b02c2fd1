// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/friction_cone.hpp"

namespace ffcontact {

/// Conditions C r >= d on tractions r = (r_n, r_t1, r_t2), which all that fulfil them have
/// in a circular cone.
///
/// r_n <= 0, and |r_t| <= b(r_n) as a polygon: rays of r_t in `rays` directions, one of
/// them a given one, and between neighbours of angle d the chord, m . r_t <= cos(d/2) b, m
/// at its middle. So |r_t| = b is reached on the rays, and within 1 - cos(pi/rays) = 8 %
/// elsewhere. A present traction nearer to the cone than that is on a ray of its own,
/// which takes the place of one that is next to it, so that nothing cuts it off.
/// b = min(c + mu |r_n|, k) are two conditions each. Without friction r_t = 0 there is no
/// inequality: it is not in C.
struct InnerCone {
  static constexpr int rays = 8;
  static constexpr int most_rows = 1 + 2 * (rays + 1);
  Matrix<double, Dynamic, 3> C;
  VectorXd d;
};

/// @param present    a traction in the cone, but for rounding: its conditions are met
/// @param direction  of one of the rays, or 0
/// @param largest    traction around: 1e-9 of it has no direction
InnerCone inner_cone(const FrictionCone& cone, const Vector3d& present,
                     const Vector2d& direction, double largest);

}  // namespace ffcontact
