// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/facing_traces.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// Parameters this close to a vertex are the vertex.
constexpr double at_vertex = 1e-10;
/// The traces may end this far, in edge lengths, beside each other; or as far as
/// coordinates may be off.
constexpr double beside = 1e-7;
/// Ends of a trace this near to a vertex, in edge lengths, are the vertex: the rest of
/// the edge would be too thin to compute with.
constexpr double sliver = 1e-4;
/// Directions that differ by less are the same.
constexpr double same_direction = 1e-9;
/// Distances below this, in edge lengths, are no gap; nor are those that coordinates may
/// be off by.
constexpr double touching = 1e-10;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double snapped(double parameter) {
  if (std::abs(parameter) < at_vertex) return 0;
  if (std::abs(parameter - 1) < at_vertex) return 1;
  return parameter;
}

struct Segment {
  Vector2d a, b;
  Vector2d at(double parameter) const { return a + parameter * (b - a); }
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
  Vector2d direction(double x) const { return n_a + x * (n_b - n_a); }
};

/// Where a ray meets the line of a segment: parameter on the segment and distance along
/// the ray's unit direction.
struct Hit {
  double parameter, distance;
};

std::optional<Hit> hit(const Rays& rays, double x, const Segment& target) {
  const Vector2d origin = rays.edge.at(x), d = target.b - target.a,
                 n = rays.direction(x);
  const double turn = cross(d, n);
  if (!(turn > 0))
    return std::nullopt;  // the outward normal (d_y, -d_x) must oppose n
  const double parameter = cross(origin - target.a, n) / turn;
  return Hit{parameter, (target.at(parameter) - origin).dot(n) / n.norm()};
}

/// Parameter in (0, 1) of the ray through a point: cross(y - x(s), n(s)) = 0, quadratic
/// in s where directions turn.
std::optional<double> ray_through(const Rays& rays, const Vector2d& y) {
  const Vector2d d = rays.edge.b - rays.edge.a, m = rays.n_b - rays.n_a,
                 r = y - rays.edge.a;
  const double c0 = cross(r, rays.n_a), c1 = cross(r, m) - cross(d, rays.n_a),
               c2 = -cross(d, m);
  const double root = c1 * c1 - 4 * c0 * c2;
  if (!(root >= 0)) return std::nullopt;
  // The root that stays finite as c2 -> 0.
  const double x = -2 * c0 / (c1 + (c1 < 0 ? -1 : 1) * std::sqrt(root));
  if (!std::isfinite(x) || x <= at_vertex || x >= 1 - at_vertex)
    return std::nullopt;
  return x;
}

/// A piece with the contact directions at its ends.
struct DirectedPiece {
  FacingPiece piece;
  Vector2d n_begin, n_end;
};

bool go_on(const DirectedPiece& before, const DirectedPiece& after) {
  return before.piece.contact_edge == after.piece.contact_edge &&
         before.piece.end == after.piece.begin;
}

/// Gives the part of the opposite edge that a piece faces to the piece before or after
/// the vertex that it all but is.
void put_end(const FacingPiece& sliver, FacingPiece& before) {
  if (before.opposite_edge != sliver.opposite_edge) return;
  before.opposite_end = sliver.opposite_end;
  before.gap_end = sliver.gap_end;
}
void put_begin(const FacingPiece& sliver, FacingPiece& after) {
  if (after.opposite_edge != sliver.opposite_edge) return;
  after.opposite_begin = sliver.opposite_begin;
  after.gap_begin = sliver.gap_begin;
}

/// Where the opposite trace ends all but at a vertex of the line it ends there: what
/// little is left of the edge beyond the end belongs to the last piece, what little of it
/// is beyond the vertex to the piece before the vertex.
/// @param pieces  ascending
void without_slivers(std::vector<DirectedPiece>& pieces) {
  std::vector<DirectedPiece> kept;
  for (std::size_t k = 0, next = 0; k < pieces.size(); k = next) {
    for (next = k + 1;
         next < pieces.size() && go_on(pieces[next - 1], pieces[next]);)
      ++next;
    FacingPiece &first = pieces[k].piece, &last = pieces[next - 1].piece;
    if (last.end <= sliver) {
      if (!kept.empty()) put_end(first, kept.back().piece);
    } else if (first.begin >= 1 - sliver) {
      if (next < pieces.size()) put_begin(last, pieces[next].piece);
    } else {
      if (first.begin <= sliver) first.begin = 0;
      if (last.end >= 1 - sliver) last.end = 1;
      kept.insert(kept.end(), pieces.begin() + static_cast<std::ptrdiff_t>(k),
                  pieces.begin() + static_cast<std::ptrdiff_t>(next));
    }
  }
  pieces = std::move(kept);
}

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
    std::vector<DirectedPiece> pieces;
    for (int e = 0; e < line_.edge_count(); ++e) add_edge(e, pieces);
    without_slivers(pieces);
    if (pieces.empty()) refuse_unfaced();
    ContactLine faced = line_;
    faced.pieces.clear();
    for (const DirectedPiece& directed : pieces)
      faced.pieces.push_back(directed.piece);
    return {faced.pieces, facing_gap(faced)};
  }

 private:
  Rays rays(int e) const {
    return {segment_of(mesh_, edges_, line_.edge[e]),
            line_.normal.col(line_.edge_node(0, e)),
            line_.normal.col(line_.edge_node(1, e))};
  }

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

  /// The nearest facing edge a ray hits, by its number in target_; of equally near ones
  /// that which it misses least.
  int nearest(const Rays& rays, double x) const {
    int best = -1;
    double distance = std::numeric_limits<double>::infinity(),
           least_missed = distance;
    for (std::size_t k = 0; k < segment_.size(); ++k) {
      const std::optional<Hit> found = hit(rays, x, segment_[k]);
      const double length = segment_[k].length();
      if (!found) continue;
      const double far = std::abs(found->distance),
                   missed =
                       std::max({0.0, -found->parameter, found->parameter - 1});
      if (missed > std::max(beside, off_ / length)) continue;
      const double equal = std::max(off_, touching * length);
      if (far > distance + equal ||
          (far > distance - equal && missed * length >= least_missed))
        continue;
      distance = far;
      least_missed = missed * length;
      best = static_cast<int>(k);
    }
    return best;
  }

  [[noreturn]] void refuse_unfaced() const {
    const Vector2d point = mesh_.origin + rays(0).edge.at(0.5);
    refuse("no point of the contact line, as (", point.x(), ", ", point.y(),
           "), faces an edge of the opposite body along its contact direction: "
           "give the "
           "labels of two sides that lie "
           "opposite to each other, or normal=");
  }

  void add_edge(int e, std::vector<DirectedPiece>& pieces) const {
    const Rays ray = rays(e);
    const std::vector<double> x = breaks(ray);
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
      const int facing = nearest(ray, 0.5 * (x[k] + x[k + 1]));
      if (facing < 0) continue;
      const Hit first = *hit(ray, x[k], segment_[facing]),
                second = *hit(ray, x[k + 1], segment_[facing]);
      append(
          {{e, x[k], x[k + 1], target_[facing], clamped(first.parameter),
            clamped(second.parameter), gap_of(first, ray), gap_of(second, ray)},
           ray.direction(x[k]),
           ray.direction(x[k + 1])},
          pieces);
    }
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

  static double clamped(double parameter) {
    return std::clamp(snapped(parameter), 0.0, 1.0);
  }

  double gap_of(const Hit& hit, const Rays& ray) const {
    return std::abs(hit.distance) < std::max(off_, touching * ray.edge.length())
               ? 0
               : hit.distance;
  }

  const Mesh& mesh_;
  const Edges& edges_;
  const ContactLine& line_;
  VectorXi target_;
  double
      off_;  ///< what the coordinates' precision makes of distances between the traces
  std::vector<Segment> segment_;
};

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Takes the displacement of the own trace from D where it is not that of the nodes: the
/// density is constant on short ends of the line, but the trace is not.
void add_own_trace(const Edges& edges, const ContactLine& line,
                   Triplets& entries) {
  for (int e = 0; e < line.edge_count(); ++e) {
    if (!is_constant_on(line, e)) continue;
    const int node = line.edge_node(0, e),
              first = edges.vertices(0, line.edge[e]),
              second = edges.vertices(1, line.edge[e]);
    const double middle = 0.5 * (line.place(0, e) + line.place(1, e));
    entries.emplace_back(node, line.vertex[node], line.length[e]);
    entries.emplace_back(node, first, -line.length[e] * (1 - middle));
    entries.emplace_back(node, second, -line.length[e] * middle);
  }
}

/// D_ij = int psi_i phi_j over the pieces, phi_j the hat functions of the opposite trace
/// [p x vertices]; two Gauss points are exact.
SparseMatrix coupling(const Mesh& mesh, const Edges& edges,
                      const ContactLine& line,
                      const std::vector<FacingPiece>& pieces) {
  const double gauss = 0.5 / std::sqrt(3.0);
  Triplets entries;
  for (const FacingPiece& piece : pieces)
    for (const double s : {0.5 - gauss, 0.5 + gauss}) {
      const int e = piece.contact_edge;
      const double x =
          line.share(e, piece.begin + s * (piece.end - piece.begin));
      const double y = piece.opposite_begin +
                       s * (piece.opposite_end - piece.opposite_begin);
      const double weight =
          0.5 * line.length[e] *
          (line.share(e, piece.end) - line.share(e, piece.begin));
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
          entries.emplace_back(
              line.edge_node(a, e), edges.vertices(b, piece.opposite_edge),
              weight * (a == 0 ? 1 - x : x) * (b == 0 ? 1 - y : y));
    }
  add_own_trace(edges, line, entries);
  SparseMatrix D(line.node_count(), mesh.vertex_count());
  D.setFromTriplets(entries.begin(), entries.end());
  return D;
}

/// What nodes between two vertices move less than the nearer one: at a share s of the way
/// to the other, s (u_near - u_other).
void add_shares_of_vertices(const Edges& edges, const ContactLine& line,
                            Triplets& entries) {
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) {
      const double place = line.place(end, e);
      if (place == 0 || place == 1 || is_constant_on(line, e)) continue;
      const int node = line.edge_node(end, e), near = place < 0.5 ? 0 : 1;
      const double share = near == 0 ? place : 1 - place;
      entries.emplace_back(node, edges.vertices(near, line.edge[e]), share);
      entries.emplace_back(node, edges.vertices(1 - near, line.edge[e]),
                           -share);
    }
}

/// Pi = M^-1 D; its entries decay by a factor of about four a node, and those below
/// rounding are dropped.
WeightsByNode projection(const Mesh& mesh, const Edges& edges,
                         const ContactLine& line,
                         const std::vector<FacingPiece>& pieces) {
  constexpr double rounding = 1e-18;
  const Eigen::SimplicialLDLT<SparseMatrix> mass(contact_mass(line));
  const SparseMatrix D = coupling(mesh, edges, line, pieces);
  Triplets entries;
  for (int j = 0; j < D.outerSize(); ++j) {
    if (D.col(j).nonZeros() == 0) continue;
    const VectorXd column = mass.solve(VectorXd(D.col(j)));
    for (Index i = 0; i < column.size(); ++i)
      if (std::abs(column[i]) > rounding)
        entries.emplace_back(static_cast<int>(i), j, column[i]);
  }
  add_shares_of_vertices(edges, line, entries);
  WeightsByNode Pi(line.node_count(), mesh.vertex_count());
  Pi.setFromTriplets(entries.begin(), entries.end());
  return Pi;
}

WeightsByNode facing_vertices(const Mesh& mesh, const Edges& edges,
                              const ContactLine& line,
                              const std::vector<FacingPiece>& pieces) {
  Triplets entries;
  for (const FacingPiece& piece : pieces)
    for (int end = 0; end < 2; ++end)
      entries.emplace_back(line.edge_node(end, piece.contact_edge),
                           edges.vertices(1 - end, piece.opposite_edge), 1.0);
  WeightsByNode Pi(line.node_count(), mesh.vertex_count());
  Pi.setFromTriplets(entries.begin(), entries.end(),
                     [](double first, double) { return first; });
  return Pi;
}

/// Joins pieces to the contact edges of a line.
class PieceJoiner {
 public:
  /// @param whole  the line that the pieces number edges of
  PieceJoiner(const Edges& edges, const ContactLine& whole)
      : edges_(edges), whole_(whole) {}

  ContactLine line(const std::vector<DirectedPiece>& pieces) {
    std::vector<Run> runs;
    for (const DirectedPiece& next : pieces) {
      if (runs.empty() || !go_on(runs.back().last, next) ||
          !same(runs.back().last.n_end, next.n_begin))
        runs.push_back({next, next});
      runs.back().last = next;
      pieces_.push_back(next.piece);
      pieces_.back().contact_edge = static_cast<int>(runs.size()) - 1;
    }
    for (std::size_t k = 0; k < runs.size(); ++k)
      add_edge(runs[k],
               k > 0 && share_a_node(runs[k - 1], runs[k]) &&
                   runs[k].share() < runs[k - 1].share(),
               k + 1 < runs.size() && share_a_node(runs[k], runs[k + 1]) &&
                   runs[k].share() < runs[k + 1].share());
    return joined();
  }

 private:
  /// Pieces of one mesh edge that follow each other, by the first and the last.
  struct Run {
    DirectedPiece first, last;
    int edge() const { return first.piece.contact_edge; }
    double begin() const { return first.piece.begin; }
    double end() const { return last.piece.end; }
    double share() const { return end() - begin(); }
  };

  static bool same(const Vector2d& a, const Vector2d& b) {
    return (a - b).norm() < same_direction;
  }

  bool share_a_node(const Run& run, const Run& next) const {
    return run.end() == 1 && next.begin() == 0 &&
           whole_.edge_node(1, run.edge()) ==
               whole_.edge_node(0, next.edge()) &&
           same(run.last.n_end, next.first.n_begin);
  }

  /// @param continues, precedes  whether the edge takes its density from the larger part
  ///                   of an edge before or after it
  void add_edge(const Run& run, bool continues, bool precedes) {
    const int node =
        precedes ? -1 : node_at(run.edge(), run.begin(), run.first.n_begin);
    const int next =
        continues ? node : node_at(run.edge(), run.end(), run.last.n_end);
    edge_node_.emplace_back(precedes ? next : node, next);
    part_.emplace_back(run.begin(), run.end());
    edge_.push_back(run.edge());
  }

  /// One that is there already where contact edges meet at a node of the whole line in
  /// one direction.
  int node_at(int e, double place, const Vector2d& n) {
    if (place > 0 && place < 1)
      return add_node(edges_.vertices(place < 0.5 ? 0 : 1, whole_.edge[e]), e,
                      place, n);
    const int at = whole_.edge_node(static_cast<int>(place), e);
    std::vector<int>& there = nodes_at_[at];
    for (int node : there)
      if (same(normal_[node], n)) return node;
    there.push_back(add_node(whole_.vertex[at], e, place, n));
    return there.back();
  }

  int add_node(int vertex, int e, double place, const Vector2d& n) {
    vertex_.push_back(vertex);
    normal_.push_back(n);
    abscissa_.push_back(abscissa_at(whole_, e, place));
    return static_cast<int>(vertex_.size()) - 1;
  }

  ContactLine joined() const {
    ContactLine line;
    const auto p = static_cast<Index>(vertex_.size()),
               m = static_cast<Index>(edge_.size());
    line.vertex = Map<const VectorXi>(vertex_.data(), p);
    line.abscissa = Map<const VectorXd>(abscissa_.data(), p);
    line.normal.resize(2, p);
    line.edge_node.resize(2, m);
    line.part.resize(2, m);
    for (Index i = 0; i < p; ++i) line.normal.col(i) = normal_[i];
    for (Index e = 0; e < m; ++e) {
      line.edge_node.col(e) = edge_node_[e];
      line.part.col(e) = part_[e];
    }
    line.edge = whole_.edge(edge_);
    line.length = whole_.length(edge_).cwiseProduct(
        (line.part.row(1) - line.part.row(0)).transpose());
    if (line.part.row(0).isZero(0) && (line.part.row(1).array() == 1).all())
      line.part.resize(2, 0);
    line.precision = whole_.precision;
    line.pieces = pieces_;
    return line;
  }

  const Edges& edges_;
  const ContactLine& whole_;
  std::vector<int> vertex_, edge_;  ///< edges of the whole line
  std::vector<Vector2d> normal_, part_;
  std::vector<Vector2i> edge_node_;
  std::vector<double> abscissa_;
  std::vector<FacingPiece> pieces_;
  std::map<int, std::vector<int>> nodes_at_;  ///< by node of the whole line
};

/// The contact direction at a place of a contact edge; the same to the last digit where
/// both ends have the same.
Vector2d direction_at(const ContactLine& line, int e, double place) {
  const Vector2d first = line.normal.col(line.edge_node(0, e)),
                 second = line.normal.col(line.edge_node(1, e));
  const double share = line.share(e, place);
  if (first == second || share == 0) return first;
  return share == 1 ? second
                    : Vector2d(first + share * (second - first)).normalized();
}

ContactLine with_opposite(const Mesh& mesh, const Edges& edges,
                          ContactLine line) {
  line.opposite_edge = VectorXi::Constant(line.edge_count(), -1);
  if (line.matches()) {
    line.opposite = facing_vertices(mesh, edges, line, line.pieces);
    for (const FacingPiece& piece : line.pieces)
      line.opposite_edge[piece.contact_edge] = piece.opposite_edge;
  } else {
    line.opposite = projection(mesh, edges, line, line.pieces);
  }
  return line;
}

/// Pieces with the contact directions n of a line at their ends, which are on its edges.
std::vector<DirectedPiece> directed(const ContactLine& line,
                                    const std::vector<FacingPiece>& pieces) {
  std::vector<DirectedPiece> result;
  for (const FacingPiece& piece : pieces)
    result.push_back({piece,
                      direction_at(line, piece.contact_edge, piece.begin),
                      direction_at(line, piece.contact_edge, piece.end)});
  return result;
}

/// The pieces of a line seen from the opposite one, ascending, with n turned round.
/// Nothing where two of them overlap.
std::optional<std::vector<DirectedPiece>> turned(const ContactLine& line,
                                                 const ContactLine& opposite) {
  std::map<int, int> number;  // of each mesh edge on the opposite line
  for (int e = 0; e < opposite.edge_count(); ++e) number[opposite.edge[e]] = e;
  std::vector<DirectedPiece> result;
  for (const auto& [p, n_begin, n_end] : directed(line, line.pieces))
    result.push_back(
        {{number.at(p.opposite_edge), p.opposite_end, p.opposite_begin,
          line.edge[p.contact_edge], p.end, p.begin, p.gap_end, p.gap_begin},
         -n_end,
         -n_begin});
  std::sort(result.begin(), result.end(),
            [](const DirectedPiece& a, const DirectedPiece& b) {
              return std::pair(a.piece.contact_edge, a.piece.begin) <
                     std::pair(b.piece.contact_edge, b.piece.begin);
            });
  for (std::size_t k = 1; k < result.size(); ++k) {
    const FacingPiece& before = result[k - 1].piece;
    FacingPiece& piece = result[k].piece;
    if (piece.contact_edge != before.contact_edge) continue;
    if (piece.begin < before.end - at_vertex) return std::nullopt;
    if (piece.begin < before.end + at_vertex) piece.begin = before.end;
  }
  without_slivers(result);
  return result;
}

}  // namespace

FacingTraces facing_traces(const Mesh& mesh, const Edges& edges,
                           const ContactLine& line,
                           const std::vector<int>& opposite_labels) {
  return Pairing(mesh, edges, line, opposite_labels).traces();
}

bool is_constant_on(const ContactLine& line, int e) {
  return line.edge_node(0, e) == line.edge_node(1, e);
}

bool ends_at_its_node(const ContactLine& line, int end, int e) {
  return !is_constant_on(line, e) || line.place(end, e) == end;
}

VectorXd facing_gap(const ContactLine& line) {
  VectorXd gap = VectorXd::Constant(line.node_count(),
                                    std::numeric_limits<double>::infinity());
  const auto note = [&](int end, int e, double place, double distance) {
    double& least = gap[line.edge_node(end, e)];
    if (place == line.place(end, e) && ends_at_its_node(line, end, e))
      least = std::min(least, distance);
  };
  for (const FacingPiece& piece : line.pieces) {
    note(0, piece.contact_edge, piece.begin, piece.gap_begin);
    note(1, piece.contact_edge, piece.end, piece.gap_end);
  }
  return gap;
}

double abscissa_at(const ContactLine& line, int e, double place) {
  const double first = line.abscissa[line.edge_node(0, e)],
               second = line.abscissa[line.edge_node(1, e)];
  const bool closes = second < first;  // a closed line ends where it begins
  return place == 1 && !closes ? second : first + place * line.length[e];
}

ContactLine facing_line(const Mesh& mesh, const Edges& edges,
                        const ContactLine& line, const FacingTraces& traces) {
  return with_opposite(
      mesh, edges,
      PieceJoiner(edges, line).line(directed(line, traces.pieces)));
}

std::optional<ContactLine> exchanged_line(
    const Mesh& mesh, const Edges& edges, const ContactLine& line,
    const std::vector<int>& opposite_labels) {
  ContactLine whole = smooth_contact_line(mesh, edges, opposite_labels);
  whole.precision = std::max(whole.precision, line.precision);
  const auto pieces = turned(line, whole);
  if (!pieces) return std::nullopt;
  return with_opposite(mesh, edges, PieceJoiner(edges, whole).line(*pieces));
}

ContactLine joined_lines(const std::vector<ContactLine>& lines) {
  Index nodes = 0, line_edges = 0, vertices = 0;
  for (const ContactLine& line : lines) {
    nodes += line.node_count();
    line_edges += line.edge_count();
    vertices = std::max(vertices, line.opposite.cols());
  }
  ContactLine joined;
  joined.vertex.resize(nodes);
  joined.normal.resize(2, nodes);
  joined.abscissa.resize(nodes);
  joined.edge_node.resize(2, line_edges);
  joined.edge.resize(line_edges);
  joined.length.resize(line_edges);
  if (std::any_of(lines.begin(), lines.end(),
                  [](const ContactLine& line) { return line.part.size() > 0; }))
    joined.part = Vector2d(0, 1).replicate(1, line_edges);
  if (vertices > 0) joined.opposite_edge = VectorXi::Constant(line_edges, -1);
  Triplets entries;
  int node = 0, edge = 0;
  for (const ContactLine& line : lines) {
    joined.vertex.segment(node, line.node_count()) = line.vertex;
    joined.normal.middleCols(node, line.node_count()) = line.normal;
    joined.abscissa.segment(node, line.node_count()) = line.abscissa;
    joined.precision = std::max(joined.precision, line.precision);
    joined.edge_node.middleCols(edge, line.edge_count()) =
        line.edge_node.array() + node;
    joined.edge.segment(edge, line.edge_count()) = line.edge;
    joined.length.segment(edge, line.edge_count()) = line.length;
    if (line.part.size() > 0)
      joined.part.middleCols(edge, line.edge_count()) = line.part;
    if (line.against_a_body())
      joined.opposite_edge.segment(edge, line.edge_count()) =
          line.opposite_edge;
    for (FacingPiece piece : line.pieces) {
      piece.contact_edge += edge;
      joined.pieces.push_back(piece);
    }
    for (int i = 0; i < line.node_count(); ++i)
      visit_opposite(line, i, [&](int vertex, double weight) {
        entries.emplace_back(node + i, vertex, weight);
      });
    node += line.node_count();
    edge += line.edge_count();
  }
  if (vertices > 0) {
    joined.opposite.resize(nodes, vertices);
    joined.opposite.setFromTriplets(entries.begin(), entries.end());
  }
  return joined;
}

}  // namespace ffcontact
