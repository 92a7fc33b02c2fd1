// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/facing_traces.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/plane.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/boundary_chains.hpp"
#include "ffcontact/interface/line_ends.hpp"
#include "ffcontact/interface/pairing/directed_pieces.hpp"
#include "ffcontact/interface/pairing/line_of_sight.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/mesh/facet_tree.hpp"
#include "ffcontact/mesh/separate_bodies.hpp"

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

/// A point of a contact edge and its direction, of length 1.
struct Ray {
  Vector2d origin, n;
  bool has_on_left(const Vector2d& y) const { return cross(n, y - origin) > 0; }
};

/// Where the line of a ray meets an edge that runs counter-clockwise around its body.
/// Edges that share a vertex agree on which side of the line it is.
std::optional<Crossing> crossing(const Ray& ray, const Segment& edge) {
  const bool enters = ray.has_on_left(edge.a);
  if (enters == ray.has_on_left(edge.b)) return std::nullopt;
  const Vector2d d = edge.b - edge.a;
  const double distance = cross(edge.a - ray.origin, d) / cross(ray.n, d);
  return Crossing{distance, enters};
}

/// An edge that a ray hits [mm].
struct Target {
  int edge;  ///< -1 for none
  double distance, missed;
};

/// What the lines of all rays of a contact edge may meet.
struct Met {
  std::vector<int> targets, all;  ///< mesh edges
};

/// The traces while they are paired.
class Pairing {
 public:
  Pairing(const Mesh& mesh, const Edges& edges, const ContactLine& line,
          const std::vector<int>& opposite_labels, const BoundaryCurves& curves)
      : mesh_(mesh),
        edges_(edges),
        line_(line),
        curves_(curves),
        body_(body_of_each_vertex(mesh)),
        boundary_(mesh, edges, boundary_edges(edges)),
        is_target_(edges.count(), 0),
        is_opposite_(mesh.vertex_count(), 0) {
    const ContactLine target = contact_line(mesh, edges, opposite_labels);
    off_ = 1.5 * (line.precision + target.precision);
    for (int edge : target.edge) {
      is_target_[edge] = 1;
      for (int v : edges.vertices.col(edge)) is_opposite_[v] = 1;
    }
  }

  FacingTraces traces() const {
    std::vector<DirectedPiece> found;
    for (int e = 0; e < line_.edge_count(); ++e)
      if (!shares_a_vertex(e)) add_edge(e, found);
    ContactLine faced = line_;
    faced.pieces.clear();
    for (const DirectedPiece& directed : without_slivers(std::move(found)))
      faced.pieces.push_back(directed.piece);
    if (faced.pieces.empty()) {
      require_own_vertices();
      refuse_unfaced();
    }
    return {faced.pieces, facing_gap(faced)};
  }

  /// A place where the line touches a target; nothing where it touches none.
  std::optional<TouchingPlace> touching_place() const {
    for (int e = 0; e < line_.edge_count(); ++e) {
      const Rays ray = rays(e);
      const Met met = met_by(ray);
      const std::vector<double> x = breaks(ray, met);
      for (std::size_t k = 0; k + 1 < x.size(); ++k) {
        const double middle = 0.5 * (x[k] + x[k + 1]);
        const Target next = first(targets(ray, middle, met));
        if (next.edge >= 0 && std::abs(next.distance) <= touch(ray.edge))
          return TouchingPlace{line_.edge[e], ray.edge.at(middle)};
      }
    }
    return std::nullopt;
  }

 private:
  Segment segment(int edge) const { return segment_of(mesh_, edges_, edge); }

  int body(int edge) const { return body_[edges_.vertices(0, edge)]; }

  /// As at the tip of a crack, where nothing opens or slides.
  bool shares_a_vertex(int e) const {
    const auto vertices = edges_.vertices.col(line_.edge[e]);
    return is_opposite_[vertices[0]] || is_opposite_[vertices[1]];
  }

  Rays rays(int e) const {
    return {segment(line_.edge[e]), line_.normal.col(line_.edge_node(0, e)),
            line_.normal.col(line_.edge_node(1, e))};
  }

  /// cross(y - x(s), n(s)) has Bernstein's coefficients cross(y - a, n_a), cross(y - a,
  /// n_b)/2 + cross(y - b, n_a)/2, cross(y - b, n_b): where all of them have one sign for
  /// all y of a box no line meets it.
  Met met_by(const Rays& rays) const {
    const Vector2d most = rays.n_a.cwiseAbs().cwiseMax(rays.n_b.cwiseAbs());
    const auto may_meet = [&](const Box<2>& box) {
      const Vector2d to_a = box.middle - rays.edge.a,
                     to_b = box.middle - rays.edge.b;
      const double reach = most.y() * box.half.x() + most.x() * box.half.y() +
                           off_ + 2 * beside * box.half.norm();
      const double f[] = {cross(to_a, rays.n_a),
                          0.5 * (cross(to_a, rays.n_b) + cross(to_b, rays.n_a)),
                          cross(to_b, rays.n_b)};
      const auto [least, largest] = std::minmax_element(f, f + 3);
      return *least <= reach && *largest >= -reach;
    };
    Met met;
    met.all = boundary_.met_by(may_meet);
    for (int edge : met.all)
      if (is_target_[edge]) met.targets.push_back(edge);
    return met;
  }

  /// Where what the rays of an edge hit may change: at those through opposite vertices.
  std::vector<double> breaks(const Rays& rays, const Met& met) const {
    std::vector<double> result{0, 1};
    for (int edge : met.targets)
      for (int v : edges_.vertices.col(edge))
        if (const auto x = ray_through(rays, mesh_.vertices.col(v)))
          result.push_back(*x);
    std::sort(result.begin(), result.end());
    const auto same = [](double a, double b) { return b - a < at_vertex; };
    result.erase(std::unique(result.begin(), result.end(), same), result.end());
    return result;
  }

  std::optional<Target> target(const Rays& rays, double x, int edge) const {
    const Segment segment = this->segment(edge);
    const std::optional<Hit> found = hit(rays, x, segment);
    if (!found) return std::nullopt;
    const double length = segment.length(), missed = found->missed();
    if (missed > std::max(beside, off_ / length)) return std::nullopt;
    return Target{edge, found->distance, missed * length};
  }

  std::vector<Target> targets(const Rays& rays, double x,
                              const Met& met) const {
    std::vector<Target> found;
    for (int edge : met.targets)
      if (const auto next = target(rays, x, edge)) found.push_back(*next);
    return found;
  }

  /// The distance below which a place touches an edge.
  double touch(const Segment& edge) const {
    return std::max(off_, touching * edge.length());
  }

  /// Overlaps come before what is in front, the nearer before the farther; of equally
  /// near ones that which the ray misses least.
  bool comes_first(const Target& next, const Target& best) const {
    const double equal = touch(segment(next.edge));
    const bool in_front = next.distance > equal;
    if (in_front != (best.distance > equal)) return !in_front;
    const double further = std::abs(next.distance) - std::abs(best.distance);
    if (further > equal) return false;
    return further <= -equal || next.missed < best.missed;
  }

  Target first(const std::vector<Target>& targets) const {
    Target best{-1, infinity, infinity};
    for (const Target& next : targets)
      if (comes_first(next, best)) best = next;
    return best;
  }

  std::vector<Crossing> crossings(const Ray& ray, const Met& met,
                                  int body) const {
    std::vector<Crossing> found;
    for (int edge : met.all)
      if (this->body(edge) == body)
        if (const auto next = crossing(ray, segment(edge)))
          found.push_back(*next);
    return found;
  }

  /// @param own  body
  bool is_faced(const Target& target, const Ray& ray, const Met& met,
                int own) const {
    const double touching = touch(segment(target.edge));
    if (std::abs(target.distance) <= touching) return true;
    const int other = body(target.edge);
    const LineOfSight line{crossings(ray, met, own), crossings(ray, met, other),
                           own == other, touching};
    return line.is_faced(target.distance);
  }

  /// The edge that a ray faces; -1 for none.
  int faced(const Rays& rays, double x, const Met& met, int own) const {
    const Ray ray{rays.edge.at(x), rays.direction(x).normalized()};
    std::vector<Target> left = targets(rays, x, met);
    for (;;) {
      const Target next = first(left);
      if (next.edge < 0 || is_faced(next, ray, met, own)) return next.edge;
      left.erase(std::find_if(
          left.begin(), left.end(),
          [&](const Target& target) { return target.edge == next.edge; }));
    }
  }

  /// @throws std::invalid_argument  if all edges do, as those of a crack of two edges
  void require_own_vertices() const {
    for (int e = 0; e < line_.edge_count(); ++e)
      if (!shares_a_vertex(e)) return;
    refuse("every edge of the contact line, as at ",
           in_words(Vector2d(mesh_.origin + rays(0).edge.at(0.5))),
           ", has a vertex of the edges that it faces, where nothing opens: "
           "divide the faces of a crack into three edges at least");
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
    const Met met = met_by(ray);
    const std::vector<double> x = breaks(ray, met);
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
      const int facing =
          faced(ray, 0.5 * (x[k] + x[k + 1]), met, body(line_.edge[e]));
      if (facing >= 0)
        append(facing_piece(e, ray, x[k], x[k + 1], facing), pieces);
    }
  }

  DirectedPiece facing_piece(int e, const Rays& ray, double begin, double end,
                             int facing) const {
    const Hit first = *hit(ray, begin, segment(facing));
    const Hit second = *hit(ray, end, segment(facing));
    const auto gap = [&](const Hit& hit, double x) {
      const Vector2d beside = curves_.beside(facing, clamped(hit.parameter)) -
                              curves_.beside(line_.edge[e], x);
      return gap_of(hit.distance + beside.dot(ray.direction(x).normalized()),
                    ray);
    };
    return {{e, begin, end, facing, clamped(first.parameter),
             clamped(second.parameter), gap(first, begin), gap(second, end)},
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

  double gap_of(double distance, const Rays& ray) const {
    return std::abs(distance) < touch(ray.edge) ? 0 : distance;
  }

  const Mesh& mesh_;
  const Edges& edges_;
  const ContactLine& line_;
  const BoundaryCurves& curves_;
  const std::vector<int> body_;  ///< of each vertex
  const FacetTree<2> boundary_;
  Flags is_target_;    ///< of each edge
  Flags is_opposite_;  ///< of each vertex, whether it is one of a target's
  /// what the coordinates' precision makes of distances between the traces
  double off_;
};

}  // namespace

FacingTraces facing_traces(const Mesh& mesh, const Edges& edges,
                           const ContactLine& line,
                           const std::vector<int>& opposite_labels,
                           const BoundaryCurves& curves) {
  return Pairing(mesh, edges, line, opposite_labels, curves).traces();
}

std::optional<TouchingPlace> touching_place(
    const Mesh& mesh, const Edges& edges, const ContactLine& line,
    const std::vector<int>& opposite_labels) {
  return Pairing(mesh, edges, line, opposite_labels, {}).touching_place();
}

}  // namespace ffcontact
