// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/line_parts.hpp"

#include "ffcontact/base/plane.hpp"
#include "ffcontact/mesh/straight_runs.hpp"
#include "ffcontact/mesh/turns.hpp"

namespace ffcontact {

namespace {

/// Which points and edges of a chain a smooth curve may have.
class Curving {
 public:
  Curving(const Ref<const Matrix2Xd>& chain, double tolerance, double corner)
      : turns_(chain),
        runs_(straight_runs(chain, tolerance)),
        corner_(corner) {}

  const std::vector<int>& runs() const { return runs_; }

  /// May a curve go through a point?
  bool is_smooth(Index k) const {
    return turns_.is_inner(k) && turns_.turn(k) <= corner_ &&
           turns_.is_smooth(k);
  }

  /// Is a straight run the chord of a curve, or two chords beside a point where it bends
  /// the other way?
  bool is_curved(std::size_t run) const {
    const int first = runs_[run], last = runs_[run + 1];
    if (last - first == 1) return !is_tangent(first);
    return last - first == 2 && is_smooth(first) && is_smooth(last) &&
           side(first) * side(last) < 0;
  }

  /// A part that is a curve.
  LinePart curve(int first, int last) const {
    if (last - first == turns_.edges() && is_smooth(0))
      return {first, last, false, true, true};
    return {first, last, false, goes_on_at(first, 1), goes_on_at(last, -1)};
  }

 private:
  /// Does a curve whose end is point k, with its edges on one side (+1 after, -1 before),
  /// go on along the straight line on the other?
  bool goes_on_at(Index k, int towards) const {
    return turns_.is_inner(k) && side(k) == side(k + towards) &&
           is_half_of_turn_beyond(k, towards, 0.6);
  }

  /// By which sign the chain turns at a point; 0 at its ends.
  int side(Index k) const {
    if (!turns_.is_inner(k)) return 0;
    return cross(turns_.edge(k - 1), turns_.edge(k)) > 0 ? 1 : -1;
  }

  /// Is the turn at point k half of that of the curve along its edge after (before) it,
  /// within a part of it?
  bool is_half_of_turn_beyond(Index k, int towards, double within) const {
    const double along = turns_.length(towards > 0 ? k : k - 1),
                 half = 0.5 * turns_.curvature(k + towards) * along;
    return std::abs(turns_.turn(k) - half) <= within * half;
  }

  /// Is a single edge long, and tangential to a curve that begins at one of its ends?
  bool is_tangent(Index edge) const {
    constexpr double within = 0.2;
    const auto touches_at = [&](Index k, int towards) {
      return turns_.is_inner(k) && turns_.is_inner(k + towards) &&
             turns_.length(edge) > 2 * turns_.length(towards > 0 ? k : k - 1) &&
             is_half_of_turn_beyond(k, towards, within);
    };
    return touches_at(edge, -1) || touches_at(edge + 1, 1);
  }

  Turns<2> turns_;
  std::vector<int> runs_;
  double corner_;
};

/// Along a straight part.
Vector2d direction_of(const Ref<const Matrix2Xd>& chain, const LinePart& part) {
  return (chain.col(part.last) - chain.col(part.first)).normalized();
}

/// The run after the last that one curve from run r on has.
std::size_t end_of_curve(const Curving& curving, std::size_t r) {
  const std::vector<int>& runs = curving.runs();
  std::size_t end = r + 1;
  if (!curving.is_curved(r)) return end;
  while (end + 1 < runs.size() && curving.is_curved(end) &&
         curving.is_smooth(runs[end]))
    ++end;
  return end;
}

}  // namespace

std::vector<LinePart> line_parts(const Ref<const Matrix2Xd>& chain,
                                 double tolerance, double corner) {
  constexpr int fewest = 3;  // edges of a curve
  const Curving curving(chain, tolerance, corner);
  const std::vector<int>& runs = curving.runs();
  std::vector<LinePart> parts;
  for (std::size_t r = 0; r + 1 < runs.size();) {
    const std::size_t end = end_of_curve(curving, r);
    const bool is_curve = runs[end] - runs[r] >= fewest && curving.is_curved(r);
    if (is_curve) parts.push_back(curving.curve(runs[r], runs[end]));
    for (; r < end; ++r)
      if (!is_curve) parts.push_back({runs[r], runs[r + 1], true});
  }
  return parts;
}

SmoothCurve<2> curve_of(const Ref<const Matrix2Xd>& chain,
                        const std::vector<LinePart>& parts, std::size_t part) {
  const LinePart& curve = parts[part];
  const Matrix2Xd points = chain.middleCols(curve.first, curve.edges() + 1);
  const std::size_t count = parts.size();
  const bool closed = count == 1 && curve.goes_on_before && curve.goes_on_after;
  EndTangents<2> ends;
  if (const LinePart& before = parts[(part + count - 1) % count];
      curve.goes_on_before && before.straight)
    ends.first = direction_of(chain, before);
  if (const LinePart& after = parts[(part + 1) % count];
      curve.goes_on_after && after.straight)
    ends.last = direction_of(chain, after);
  return smooth_curve<2>(points, closed, ends);
}

int loop_start(const Ref<const Matrix2Xd>& loop, double tolerance,
               double corner) {
  const Index n = loop.cols() - 1;
  const Turns<2> turns(loop);
  Index sharpest = 0;
  for (Index k = 0; k < n; ++k)
    if (turns.turn(k) > turns.turn(sharpest)) sharpest = k;
  Matrix2Xd from_sharpest(2, n + 1);
  for (Index k = 0; k <= n; ++k)
    from_sharpest.col(k) = loop.col((k + sharpest) % n);
  const Curving curving(from_sharpest, tolerance, corner);
  const std::vector<int>& runs = curving.runs();
  for (std::size_t r = 0; r + 1 < runs.size(); ++r)
    if (!curving.is_smooth(runs[r]) || !curving.is_curved(r))
      return static_cast<int>((runs[r] + sharpest) % n);
  return static_cast<int>(sharpest);
}

}  // namespace ffcontact
