// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/friction_cone.hpp"

namespace ffcontact {

/// The point of a circular cone nearest to r = (r_n, r_t1, r_t2), and how it changes with
/// r:
///     r_n <= 0,   |r_t| <= min(c + mu |r_n|, k).
/// In the half plane of (r_n, |r_t|) this is a convex polygon: the segment from (0, 0) to
/// (0, min(c, k)), a side along (-1, mu), and one along (-1, 0) where |r_t| = k.
struct ConeProjection {
  Vector3d point;
  Matrix3d
      slope;  ///< a generalised derivative, symmetric and positive semidefinite
};
ConeProjection cone_projection(const FrictionCone& cone, const Vector3d& r);

}  // namespace ffcontact
