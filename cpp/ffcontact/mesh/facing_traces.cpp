// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/facing_traces.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// Parameters this close to a vertex are the vertex.
constexpr double at_vertex = 1e-10;
/// The traces may end this far, in edge lengths, beside each other; or as far as coordinates may be off.
constexpr double beside = 1e-7;
/// Distances below this, in edge lengths, are no gap; nor are those that coordinates may be off by.
constexpr double touching = 1e-10;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double snapped(double parameter) {
  if (std::abs(parameter) < at_vertex) return 0;
  if (std::abs(parameter - 1) < at_vertex) return 1;
  return parameter;
}

struct Segment {
  Eigen::Vector2d a, b;
  Eigen::Vector2d at(double parameter) const { return a + parameter * (b - a); }
  double length() const { return (b - a).norm(); }
};

Segment segment_of(const Mesh& mesh, const Edges& edges, int edge) {
  return {mesh.vertices.col(edges.vertices(0, edge)), mesh.vertices.col(edges.vertices(1, edge))};
}

/// A contact edge with the contact directions at its ends.
struct Rays {
  Segment edge;
  Eigen::Vector2d n_a, n_b;
  Eigen::Vector2d direction(double x) const { return n_a + x * (n_b - n_a); }
};

/// Where a ray meets the line of a segment: parameter on the segment and distance along the ray's unit direction.
struct Hit {
  double parameter, distance;
};

std::optional<Hit> hit(const Rays& rays, double x, const Segment& target) {
  const Eigen::Vector2d origin = rays.edge.at(x), d = target.b - target.a, n = rays.direction(x);
  const double turn = cross(d, n);
  if (!(turn > 0)) return std::nullopt;  // the outward normal (d_y, -d_x) must oppose n
  const double parameter = cross(origin - target.a, n) / turn;
  return Hit{parameter, (target.at(parameter) - origin).dot(n) / n.norm()};
}

/// Parameter in (0, 1) of the ray through a point: cross(y - x(s), n(s)) = 0, quadratic in s where directions turn.
std::optional<double> ray_through(const Rays& rays, const Eigen::Vector2d& y) {
  const Eigen::Vector2d d = rays.edge.b - rays.edge.a, m = rays.n_b - rays.n_a, r = y - rays.edge.a;
  const double c0 = cross(r, rays.n_a), c1 = cross(r, m) - cross(d, rays.n_a), c2 = -cross(d, m);
  const double root = c1 * c1 - 4 * c0 * c2;
  if (!(root >= 0)) return std::nullopt;
  // The root that stays finite as c2 -> 0.
  const double x = -2 * c0 / (c1 + (c1 < 0 ? -1 : 1) * std::sqrt(root));
  if (!std::isfinite(x) || x <= at_vertex || x >= 1 - at_vertex) return std::nullopt;
  return x;
}

/// The traces while they are paired.
class Pairing {
 public:
  Pairing(const Mesh& mesh, const Edges& edges, const ContactLine& line, const std::vector<int>& opposite_labels)
      : mesh_(mesh), edges_(edges), line_(line) {
    const ContactLine target = contact_line(mesh, edges, opposite_labels);
    target_ = target.edge;
    off_ = 1.5 * (line.precision + target.precision);
    for (int edge : target_) segment_.push_back(segment_of(mesh, edges, edge));
  }

  FacingTraces traces() const {
    FacingTraces result;
    result.gap = Eigen::VectorXd::Constant(line_.node_count(), std::numeric_limits<double>::infinity());
    for (int e = 0; e < line_.edge_count(); ++e) add_edge(e, result);
    return result;
  }

 private:
  Rays rays(int e) const {
    return {segment_of(mesh_, edges_, line_.edge[e]), line_.normal.col(line_.edge_node(0, e)),
            line_.normal.col(line_.edge_node(1, e))};
  }

  std::vector<double> breaks(const Rays& rays) const {
    std::vector<double> result{0, 1};
    for (const Segment& segment : segment_)
      for (const Eigen::Vector2d& end : {segment.a, segment.b})
        if (const std::optional<double> x = ray_through(rays, end)) result.push_back(*x);
    std::sort(result.begin(), result.end());
    const auto same = [](double a, double b) { return b - a < at_vertex; };
    result.erase(std::unique(result.begin(), result.end(), same), result.end());
    return result;
  }

  /// The nearest facing edge a ray hits, by its number in target_; of equally near ones that which it misses least.
  int nearest(const Rays& rays, double x) const {
    int best = -1;
    double distance = std::numeric_limits<double>::infinity(), least_missed = distance;
    for (std::size_t k = 0; k < segment_.size(); ++k) {
      const std::optional<Hit> found = hit(rays, x, segment_[k]);
      const double length = segment_[k].length();
      if (!found) continue;
      const double far = std::abs(found->distance), missed = std::max({0.0, -found->parameter, found->parameter - 1});
      if (missed > std::max(beside, off_ / length)) continue;
      const double equal = std::max(off_, touching * length);
      if (far > distance + equal || (far > distance - equal && missed * length >= least_missed)) continue;
      distance = far;
      least_missed = missed * length;
      best = static_cast<int>(k);
    }
    if (best < 0) {
      const Eigen::Vector2d point = mesh_.origin + rays.edge.at(x);
      refuse(
          "the contact line at (", point.x(), ", ", point.y(),
          ") faces no edge of the opposite body along its contact direction: exchange the bodies or shorten the line");
    }
    return best;
  }

  void add_edge(int e, FacingTraces& result) const {
    const Rays ray = rays(e);
    const std::vector<double> x = breaks(ray);
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
      const int facing = nearest(ray, 0.5 * (x[k] + x[k + 1]));
      const Hit first = *hit(ray, x[k], segment_[facing]), second = *hit(ray, x[k + 1], segment_[facing]);
      const FacingPiece piece{e, x[k], x[k + 1], target_[facing], clamped(first.parameter), clamped(second.parameter)};
      append(piece, result.pieces);
      if (x[k] == 0) note_gap(line_.edge_node(0, e), first.distance, ray, result);
      if (x[k + 1] == 1) note_gap(line_.edge_node(1, e), second.distance, ray, result);
    }
  }

  /// Pieces of the same two edges are one: the break between them was a vertex that no ray of the edge hits first.
  static void append(const FacingPiece& piece, std::vector<FacingPiece>& pieces) {
    if (pieces.empty() || pieces.back().contact_edge != piece.contact_edge ||
        pieces.back().opposite_edge != piece.opposite_edge) {
      pieces.push_back(piece);
      return;
    }
    pieces.back().end = piece.end;
    pieces.back().opposite_end = piece.opposite_end;
  }

  static double clamped(double parameter) { return std::clamp(snapped(parameter), 0.0, 1.0); }

  void note_gap(int node, double distance, const Rays& ray, FacingTraces& result) const {
    if (std::abs(distance) < std::max(off_, touching * ray.edge.length())) distance = 0;
    result.gap[node] = std::min(result.gap[node], distance);
  }

  const Mesh& mesh_;
  const Edges& edges_;
  const ContactLine& line_;
  Eigen::VectorXi target_;
  double off_;  ///< what the coordinates' precision makes of distances between the traces
  std::vector<Segment> segment_;
};

using Triplets = std::vector<Eigen::Triplet<double>>;

/// D_ij = int psi_i phi_j over the pieces, phi_j the hat functions of the opposite trace [p x vertices]; two Gauss points are exact.
Eigen::SparseMatrix<double> coupling(const Mesh& mesh, const Edges& edges, const ContactLine& line,
                                     const std::vector<FacingPiece>& pieces) {
  const double gauss = 0.5 / std::sqrt(3.0);
  Triplets entries;
  for (const FacingPiece& piece : pieces)
    for (const double s : {0.5 - gauss, 0.5 + gauss}) {
      const double x = piece.begin + s * (piece.end - piece.begin);
      const double y = piece.opposite_begin + s * (piece.opposite_end - piece.opposite_begin);
      const double weight = 0.5 * line.length[piece.contact_edge] * (piece.end - piece.begin);
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
          entries.emplace_back(line.edge_node(a, piece.contact_edge), edges.vertices(b, piece.opposite_edge),
                               weight * (a == 0 ? 1 - x : x) * (b == 0 ? 1 - y : y));
    }
  Eigen::SparseMatrix<double> D(line.node_count(), mesh.vertex_count());
  D.setFromTriplets(entries.begin(), entries.end());
  return D;
}

/// Pi = M^-1 D; its entries decay by a factor of about four a node, and those below rounding are dropped.
WeightsByNode projection(const Mesh& mesh, const Edges& edges, const ContactLine& line,
                         const std::vector<FacingPiece>& pieces) {
  constexpr double rounding = 1e-18;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> mass(contact_mass(line));
  const Eigen::SparseMatrix<double> D = coupling(mesh, edges, line, pieces);
  Triplets entries;
  for (int j = 0; j < D.outerSize(); ++j) {
    if (D.col(j).nonZeros() == 0) continue;
    const Eigen::VectorXd column = mass.solve(Eigen::VectorXd(D.col(j)));
    for (Eigen::Index i = 0; i < column.size(); ++i)
      if (std::abs(column[i]) > rounding) entries.emplace_back(static_cast<int>(i), j, column[i]);
  }
  WeightsByNode Pi(line.node_count(), mesh.vertex_count());
  Pi.setFromTriplets(entries.begin(), entries.end());
  return Pi;
}

WeightsByNode facing_vertices(const Mesh& mesh, const Edges& edges, const ContactLine& line,
                              const std::vector<FacingPiece>& pieces) {
  Triplets entries;
  for (const FacingPiece& piece : pieces)
    for (int end = 0; end < 2; ++end)
      entries.emplace_back(line.edge_node(end, piece.contact_edge), edges.vertices(1 - end, piece.opposite_edge), 1.0);
  WeightsByNode Pi(line.node_count(), mesh.vertex_count());
  Pi.setFromTriplets(entries.begin(), entries.end(), [](double first, double) { return first; });
  return Pi;
}

}  // namespace

FacingTraces facing_traces(const Mesh& mesh, const Edges& edges, const ContactLine& line,
                           const std::vector<int>& opposite_labels) {
  return Pairing(mesh, edges, line, opposite_labels).traces();
}

ContactLine facing_line(const Mesh& mesh, const Edges& edges, ContactLine line, const FacingTraces& traces) {
  line.pieces = traces.pieces;
  line.opposite_edge = Eigen::VectorXi::Constant(line.edge_count(), -1);
  if (line.matches()) {
    line.opposite = facing_vertices(mesh, edges, line, traces.pieces);
    for (const FacingPiece& piece : traces.pieces) line.opposite_edge[piece.contact_edge] = piece.opposite_edge;
  } else {
    line.opposite = projection(mesh, edges, line, traces.pieces);
  }
  return line;
}

ContactLine joined_lines(const std::vector<ContactLine>& lines) {
  Eigen::Index nodes = 0, line_edges = 0, vertices = 0;
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
  if (vertices > 0) joined.opposite_edge = Eigen::VectorXi::Constant(line_edges, -1);
  Triplets entries;
  int node = 0, edge = 0;
  for (const ContactLine& line : lines) {
    joined.vertex.segment(node, line.node_count()) = line.vertex;
    joined.normal.middleCols(node, line.node_count()) = line.normal;
    joined.abscissa.segment(node, line.node_count()) = line.abscissa;
    joined.precision = std::max(joined.precision, line.precision);
    joined.edge_node.middleCols(edge, line.edge_count()) = line.edge_node.array() + node;
    joined.edge.segment(edge, line.edge_count()) = line.edge;
    joined.length.segment(edge, line.edge_count()) = line.length;
    if (line.against_a_body()) joined.opposite_edge.segment(edge, line.edge_count()) = line.opposite_edge;
    for (FacingPiece piece : line.pieces) {
      piece.contact_edge += edge;
      joined.pieces.push_back(piece);
    }
    for (int i = 0; i < line.node_count(); ++i)
      visit_opposite(line, i, [&](int vertex, double weight) { entries.emplace_back(node + i, vertex, weight); });
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
