// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/smooth_curve.hpp"

namespace ffcontact {

/// A part of a chain between two of its points: a straight line, or a smooth curve that
/// its edges are chords of.
struct LinePart {
  int first, last;
  bool straight;
  /// whether a curve goes on along the straight line before it, and along that after it;
  /// around a loop of nothing else both
  bool goes_on_before = false, goes_on_after = false;
  int edges() const { return last - first; }
};

/// The straight lines and smooth curves of a chain.
///
/// A curve has at least three edges; at each point inside it turns by at most `corner`
/// [rad] and as its neighbours do (Turns::is_smooth); no two of its edges are on one
/// straight line, except those beside a point where it bends the other way. An edge of
/// more than twice the length of its neighbour is a straight line where the chain turns
/// between them by half of what the curve turns along the neighbour, within a fifth: it is
/// the tangent there. All other points between straight lines are corners.
///
/// A curve goes on along a straight line where the chain turns by 0.4 to 1.6 of half of
/// what the curve turns along its edge there.
/// @param chain      a loop (its last point is the first) starts at loop_start
/// @param tolerance  of straight_runs
std::vector<LinePart> line_parts(const Ref<const Matrix2Xd>& chain,
                                 double tolerance, double corner);

/// The curve of a part that is one, with the tangents of the straight lines that it goes
/// on along.
/// @param parts  line_parts of the chain
SmoothCurve<2> curve_of(const Ref<const Matrix2Xd>& chain,
                        const std::vector<LinePart>& parts, std::size_t part);

/// Where a loop is to start, so that no curve goes on across its start; any point of a
/// loop that is one smooth curve.
int loop_start(const Ref<const Matrix2Xd>& loop, double tolerance,
               double corner);

}  // namespace ffcontact
