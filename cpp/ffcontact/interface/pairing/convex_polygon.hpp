// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Corners of a convex polygon in the plane, counter-clockwise [2 x k]; none if it is
/// empty.
using ConvexPolygon = Matrix2Xd;

double polygon_area(const ConvexPolygon& polygon);

/// What two polygons share.
ConvexPolygon intersection(const ConvexPolygon& a, const ConvexPolygon& b);

/// What a has beyond b, in pieces that do not overlap.
std::vector<ConvexPolygon> difference(const ConvexPolygon& a,
                                      const ConvexPolygon& b);

}  // namespace ffcontact
