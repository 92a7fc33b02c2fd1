// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/facing_traces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/plane.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/directed_pieces.hpp"
#include "ffcontact/interface/line_ends.hpp"

namespace ffcontact {

namespace {

/// Parameters this close to a vertex are the vertex.
constexpr double at_vertex = 1e-10;
/// The traces may end this far, in edge lengths, beside each other; or as far as
/// coordinates may be off.
constexpr double beside = 1e-7;
/// Distances below this, in edge lengths, are no gap; nor are those that coordinates may
/// be off by.
constexpr double touching = 1e-10;

/// On the edge, at its vertex when close to that.
double clamped(double parameter) {
  if (parameter < at_vertex) return 0;
  if (parameter - 1 > -at_vertex) return 1;
  return parameter;
}

struct Segment {
  Vector2d a, b;
  Vector2d at(double parameter) const { return between(a, b, parameter); }
  double length() const { return (b - a).norm(); }
};

Segment segment_of(const Mesh& mesh, const Edges& edges, int edge) {
  return {mesh.vertices.col(edges.vertices(0, edge)),
          mesh.vertices.col(edges.vertices(1, edge))};
}

/// A contact edge with the contact directions at its ends.
struct Rays {
  Segment edge;
  Vector2d n_a, n_b;
  Vector2d direction(double x) const { return between(n_a, n_b, x); }
};

/// Where a ray meets the line of a segment: parameter on the segment and distance along
/// the ray's unit direction.
struct Hit {
  double parameter, distance;
  /// How far it is beside the segment, in lengths of that.
  double missed() const { return std::max({0.0, -parameter, parameter - 1}); }
};

std::optional<Hit> hit(const Rays& rays, double x, const Segment& target) {
  const Vector2d origin = rays.edge.at(x), n = rays.direction(x);
  const Vector2d d = target.b - target.a;
  const double turn = cross(d, n);
  if (!(turn > 0))
    return std::nullopt;  // the outward normal (d_y, -d_x) must oppose n
  const double parameter = cross(origin - target.a, n) / turn;
  return Hit{parameter, (target.at(parameter) - origin).dot(n) / n.norm()};
}

/// Parameter in (0, 1) of the ray through a point: cross(y - x(s), n(s)) = 0, quadratic
/// in s where directions turn.
std::optional<double> ray_through(const Rays& rays, const Vector2d& y) {
  const Vector2d d = rays.edge.b - rays.edge.a, r = y - rays.edge.a;
  const Vector2d m = rays.n_b - rays.n_a;
  const double c1 = cross(r, m) - cross(d, rays.n_a);
  const auto x = finite_root(cross(r, rays.n_a), c1, -cross(d, m));
  return x && *x > at_vertex && *x < 1 - at_vertex ? x : std::nullopt;
}

/// An edge that a ray hits, by its number among the targets [mm].
struct Target {
  int number;
  double distance, missed;
};

/// The traces while they are paired.
class Pairing {
 public:
  Pairing(const Mesh& mesh, const Edges& edges, const ContactLine& line,
          const std::vector<int>& opposite_labels)
      : mesh_(mesh), edges_(edges), line_(line) {
    const ContactLine target = contact_line(mesh, edges, opposite_labels);
    target_ = target.edge;
    off_ = 1.5 * (line.precision + target.precision);
    for (int edge : target_) segment_.push_back(segment_of(mesh, edges, edge));
  }

  FacingTraces traces() const {
    std::vector<DirectedPiece> found;
    for (int e = 0; e < line_.edge_count(); ++e) add_edge(e, found);
    ContactLine faced = line_;
    faced.pieces.clear();
    for (const DirectedPiece& directed : without_slivers(std::move(found)))
      faced.pieces.push_back(directed.piece);
    if (faced.pieces.empty()) refuse_unfaced();
    return {faced.pieces, facing_gap(faced)};
  }

 private:
  Rays rays(int e) const {
    return {segment_of(mesh_, edges_, line_.edge[e]),
            line_.normal.col(line_.edge_node(0, e)),
            line_.normal.col(line_.edge_node(1, e))};
  }

  /// Where what the rays of an edge hit may change: at those through opposite vertices.
  std::vector<double> breaks(const Rays& rays) const {
    std::vector<double> result{0, 1};
    for (const Segment& segment : segment_)
      for (const Vector2d& end : {segment.a, segment.b})
        if (const std::optional<double> x = ray_through(rays, end))
          result.push_back(*x);
    std::sort(result.begin(), result.end());
    const auto same = [](double a, double b) { return b - a < at_vertex; };
    result.erase(std::unique(result.begin(), result.end(), same), result.end());
    return result;
  }

  std::optional<Target> target(const Rays& rays, double x, int k) const {
    const std::optional<Hit> found = hit(rays, x, segment_[k]);
    if (!found) return std::nullopt;
    const double length = segment_[k].length(), missed = found->missed();
    if (missed > std::max(beside, off_ / length)) return std::nullopt;
    return Target{k, std::abs(found->distance), missed * length};
  }

  /// The distance below which a place touches an edge.
  double touch(const Segment& edge) const {
    return std::max(off_, touching * edge.length());
  }

  /// Of equally near ones that which the ray misses least comes first.
  bool comes_first(const Target& next, const Target& best) const {
    const double equal = touch(segment_[next.number]);
    if (next.distance > best.distance + equal) return false;
    return next.distance <= best.distance - equal || next.missed < best.missed;
  }

  /// The nearest facing edge a ray hits, by its number in target_; -1 for none.
  int nearest(const Rays& rays, double x) const {
    constexpr double far = infinity;
    Target best{-1, far, far};
    for (int k = 0; k < target_.size(); ++k) {
      const std::optional<Target> next = target(rays, x, k);
      if (next && comes_first(*next, best)) best = *next;
    }
    return best.number;
  }

  [[noreturn]] void refuse_unfaced() const {
    const Vector2d point = mesh_.origin + rays(0).edge.at(0.5);
    refuse("no point of the contact line, as ", in_words(point),
           ", faces an edge of the opposite body along its contact direction: "
           "give the labels of two sides that lie opposite to each other, or "
           "normal=");
  }

  void add_edge(int e, std::vector<DirectedPiece>& pieces) const {
    const Rays ray = rays(e);
    const std::vector<double> x = breaks(ray);
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
      const int facing = nearest(ray, 0.5 * (x[k] + x[k + 1]));
      if (facing >= 0)
        append(facing_piece(e, ray, x[k], x[k + 1], facing), pieces);
    }
  }

  DirectedPiece facing_piece(int e, const Rays& ray, double begin, double end,
                             int facing) const {
    const Hit first = *hit(ray, begin, segment_[facing]);
    const Hit second = *hit(ray, end, segment_[facing]);
    return {
        {e, begin, end, target_[facing], clamped(first.parameter),
         clamped(second.parameter), gap_of(first, ray), gap_of(second, ray)},
        ray.direction(begin),
        ray.direction(end)};
  }

  /// Pieces of the same two edges are one: the break between them was a vertex that no
  /// ray of the edge hits first.
  static void append(const DirectedPiece& next,
                     std::vector<DirectedPiece>& pieces) {
    if (pieces.empty() || !go_on(pieces.back(), next) ||
        pieces.back().piece.opposite_edge != next.piece.opposite_edge) {
      pieces.push_back(next);
      return;
    }
    FacingPiece& piece = pieces.back().piece;
    piece.end = next.piece.end;
    piece.opposite_end = next.piece.opposite_end;
    piece.gap_end = next.piece.gap_end;
    pieces.back().n_end = next.n_end;
  }

  double gap_of(const Hit& hit, const Rays& ray) const {
    return std::abs(hit.distance) < touch(ray.edge) ? 0 : hit.distance;
  }

  const Mesh& mesh_;
  const Edges& edges_;
  const ContactLine& line_;
  VectorXi target_;
  /// what the coordinates' precision makes of distances between the traces
  double off_;
  std::vector<Segment> segment_;
};

}  // namespace

FacingTraces facing_traces(const Mesh& mesh, const Edges& edges,
                           const ContactLine& line,
                           const std::vector<int>& opposite_labels) {
  return Pairing(mesh, edges, line, opposite_labels).traces();
}

}  // namespace ffcontact
