// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/contact_line.hpp"

#include <set>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/boundary_chains.hpp"
#include "ffcontact/mesh/smooth_curve.hpp"
#include "ffcontact/mesh/straight_runs.hpp"

namespace ffcontact {

namespace {

/// A curve has at least this many edges and turns by at most this angle between them;
/// other polygons are meant.
constexpr int fewest_edges = 5;
constexpr double largest_turn = 15 * M_PI / 180;

/// What a line takes its edges for: straight lines, straight lines and the chords of
/// curves, or the chords of one curve.
enum class Shape { polygon, parts, curve };

Matrix2Xd vertices_of(const Mesh& mesh, const Edges& edges,
                      const std::vector<int>& chain) {
  std::vector<int> vertices{edges.vertices(0, chain.front())};
  for (int edge : chain) vertices.push_back(edges.vertices(1, edge));
  return mesh.vertices(Eigen::all, vertices);
}

/// The direction of the chord at every point.
Matrix2Xd chord_tangents(const Matrix2Xd& points) {
  const Vector2d chord = points.col(points.cols() - 1) - points.col(0);
  return chord.normalized().replicate(1, points.cols());
}

Matrix2Xd curve_tangents(const Matrix2Xd& points) {
  const bool closed = points.col(0) == points.col(points.cols() - 1);
  return smooth_curve(points, closed && closes_smoothly(points)).tangents;
}

/// Normals of a straight line, all that of its chord, or of a smooth curve.
Matrix2Xd normals_of(const Matrix2Xd& points, bool straight) {
  const Matrix2Xd tangents =
      straight ? chord_tangents(points) : curve_tangents(points);
  Matrix2Xd normals(2, points.cols());
  normals << tangents.row(1), -tangents.row(0);
  return normals;
}

Matrix2Xd places_of(const Mesh& mesh, const Edges& edges,
                    const std::vector<int>& boundary) {
  const Matrix2Xi vertices = edges.vertices(Eigen::all, boundary);
  return mesh.vertices(Eigen::all, vertices.reshaped()).colwise() + mesh.origin;
}

/// Appends nodes and edges to a line.
class LineBuilder {
 public:
  LineBuilder(const Mesh& mesh, const Edges& edges, Shape shape)
      : mesh_(mesh), edges_(edges), shape_(shape) {}

  /// @param tolerance  of straight_runs
  void add_chain(const std::vector<int>& chain, double tolerance) {
    const int first_node = count_of(vertex_);
    if (shape_ == Shape::curve)
      add_part(chain, 0, Matrix2Xd::Zero(2, count(chain) + 1), false);
    else
      add_parts(chain, tolerance);
    if (count(chain) > 1 && is_loop_from(first_node)) join_loop(first_node);
  }

  ContactLine line() const {
    ContactLine line;
    line.vertex = packed(vertex_);
    line.normal = packed(normal_);
    line.abscissa = packed(abscissa_);
    line.edge_node = packed(edge_node_);
    line.edge = packed(edge_);
    line.length = packed(length_);
    return line;
  }

 private:
  static int count(const std::vector<int>& chain) { return count_of(chain); }

  /// Straight lines and smooth curves, each from the node that the one before ends at
  /// where the line goes on.
  void add_parts(const std::vector<int>& chain, double tolerance) {
    const Matrix2Xd points = vertices_of(mesh_, edges_, chain);
    const int fewest =
        shape_ == Shape::polygon ? count(chain) + 1 : fewest_edges;
    double turn = 0;  // over the last edge before
    for (const LinePart& part :
         line_parts(points, tolerance, largest_turn, fewest)) {
      const Matrix2Xd normals = normals_of(
          points.middleCols(part.first, part.edges() + 1), part.straight);
      const bool shared = part.first > 0 && shares_a_node(normals, turn);
      add_part(chain, part.first, normals, shared);
      turn = turn_after(normals, part.edges() - 1);
    }
  }

  static double turn_after(const Matrix2Xd& normals, Index k) {
    return angle_between(normals.col(k), normals.col(k + 1));
  }

  /// Whether a part goes on from the one before, one of both a straight line.
  /// @param turn  of the part before over its last edge
  bool shares_a_node(const Matrix2Xd& normals, double turn) const {
    const double next_turn = turn_after(normals, 0);
    const bool one_curve = (turn > 0) != (next_turn > 0);
    return one_curve && goes_on(normals.col(0), turn + next_turn);
  }

  /// Whether the chain that began at a node ends there as one line.
  bool is_loop_from(int node) const {
    if (vertex_.back() != vertex_[node]) return false;
    if (shape_ == Shape::curve) return true;
    const double turn = angle_between(normal_[node], normal_[node + 1]);
    return goes_on(normal_[node], turn);
  }

  void add_node(int vertex, const Vector2d& normal) {
    vertex_.push_back(vertex);
    normal_.push_back(normal);
    abscissa_.push_back(arc_);
  }

  /// @return its second node
  int add_edge(int e, int first_node, const Vector2d& second_normal) {
    length_.push_back(edge_vector(mesh_, edges_, e).norm());
    arc_ += length_.back();
    add_node(edges_.vertices(1, e), second_normal);
    const int second_node = count_of(vertex_) - 1;
    edge_.push_back(e);
    edge_node_.emplace_back(first_node, second_node);
    return second_node;
  }

  /// Whether the line goes on from its last node with this normal, as a curve that turns
  /// by `turn` an edge does.
  bool goes_on(const Vector2d& normal, double turn) const {
    return angle_between(normal_.back(), normal) < 0.5 * turn;
  }

  /// @param normals  at the vertices of the chain's edges from `first` on
  /// @param shared  the last node so far is the first one of the part as well; it has the
  ///                normal of the straight one of both
  void add_part(const std::vector<int>& chain, int first,
                const Matrix2Xd& normals, bool shared) {
    if (!shared) add_node(edges_.vertices(0, chain[first]), normals.col(0));
    int node = count_of(vertex_) - 1;
    if (normals.col(0) == normals.col(1)) normal_[node] = normals.col(0);
    for (Index k = 1; k < normals.cols(); ++k)
      node = add_edge(chain[first + k - 1], node, normals.col(k));
  }

  /// A closed curve shares its first node.
  void join_loop(int first_node) {
    edge_node_.back()[1] = first_node;
    vertex_.pop_back();
    normal_.pop_back();
    abscissa_.pop_back();
  }

  const Mesh& mesh_;
  const Edges& edges_;
  const Shape shape_;
  std::vector<int> vertex_, edge_;
  std::vector<Vector2d> normal_;
  std::vector<Vector2i> edge_node_;
  std::vector<double> abscissa_, length_;
  double arc_ = 0;
};

ContactLine built_line(const Mesh& mesh, const Edges& edges,
                       const std::vector<int>& labels, Shape shape) {
  const std::vector<int> boundary = labelled_boundary(mesh, edges, labels);
  const double size = extent(mesh.vertices);
  const double precision =
      coordinate_precision(places_of(mesh, edges, boundary), size);
  LineBuilder builder(mesh, edges, shape);
  for (const std::vector<int>& chain : boundary_chains(mesh, edges, boundary))
    builder.add_chain(chain, straight_tolerance(precision, size));
  ContactLine line = builder.line();
  line.precision = precision;
  return line;
}

[[noreturn]] void refuse_direction(const Mesh& mesh, int vertex,
                                   const Vector2d& d) {
  refuse("the contact direction ", in_words(d), " at vertex ", vertex, " ",
         in_words(mesh.place(vertex)), " does not point out of the body");
}

}  // namespace

ContactLine contact_line(const Mesh& mesh, const Edges& edges,
                         const std::vector<int>& labels) {
  return built_line(mesh, edges, labels, Shape::polygon);
}

ContactLine curved_contact_line(const Mesh& mesh, const Edges& edges,
                                const std::vector<int>& labels) {
  return built_line(mesh, edges, labels, Shape::parts);
}

ContactLine smooth_contact_line(const Mesh& mesh, const Edges& edges,
                                const std::vector<int>& labels) {
  ContactLine line = built_line(mesh, edges, labels, Shape::curve);
  line.normal.setZero();
  for (int e = 0; e < line.edge_count(); ++e)
    for (int node : line.edge_node.col(e))
      line.normal.col(node) += edge_normal(mesh, edges, line.edge[e]);
  line.normal.colwise().normalize();
  return line;
}

ContactLine along_directions(const Mesh& mesh, const Edges& edges,
                             ContactLine line,
                             const Ref<const Matrix2Xd>& direction) {
  require_size("contact directions", direction.cols(), line.node_count());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int node : line.edge_node.col(e)) {
      const Vector2d d = direction.col(node);
      if (!d.allFinite() ||
          !(d.dot(edge_normal(mesh, edges, line.edge[e])) > 0))
        refuse_direction(mesh, line.vertex[node], d);
    }
  line.normal = direction.colwise().normalized();
  return line;
}

SparseMatrix contact_mass(const ContactLine& line) {
  Triplets entries;
  entries.reserve(4 * line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        entries.emplace_back(line.edge_node(a, e), line.edge_node(b, e),
                             line.length[e] / (a == b ? 3 : 6));
  return packed(line.node_count(), line.node_count(), entries);
}

Matrix2Xd contact_components(const ContactLine& line,
                             const Ref<const VectorXd>& field) {
  Matrix2Xd components(2, line.node_count());
  for (int i = 0; i < line.node_count(); ++i)
    components.col(i) = line.frame(i).transpose() * jump_at(line, i, field);
  return components;
}

}  // namespace ffcontact
