// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// How far a point may be from where it was meant to be, in each coordinate: one unit of
/// the last decimal that the coordinates of all points need, as files with few digits
/// leave them, or the rounding of their sums, 4 eps max |x|, where they need all.
/// @param size  of the body; coordinates with fewer than five digits of it are taken as
///              meant
double coordinate_precision(const Ref<const Matrix2Xd>& points, double size);

/// Parts of a chain of points that lie on one straight line, however many edges they
/// have: within `tolerance` of a line through their first point, from which their
/// distance grows. Parts are as long as possible, from the first point on.
/// @return the first point of each part, and the last point of the chain
std::vector<int> straight_runs(const Ref<const Matrix2Xd>& chain,
                               double tolerance);

/// What straight_runs may allow points of this precision: two of them are off by half a
/// unit in both coordinates; and at least 1e-9 of the body's size.
inline double straight_tolerance(double precision, double size) {
  return std::max(1.5 * precision, 1e-9 * size);
}

/// Diagonal of the box around points.
double extent(const Ref<const Matrix2Xd>& points);

}  // namespace ffcontact
