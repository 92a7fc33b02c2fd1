// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/contact_line.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/curve_directions.hpp"
#include "ffcontact/mesh/smooth_curve.hpp"
#include "ffcontact/mesh/straight_runs.hpp"

namespace ffcontact {

namespace {

std::vector<int> labelled_boundary(const Mesh& mesh, const Edges& edges,
                                   const std::vector<int>& labels) {
  if (labels.empty()) refuse("no contact label is given");
  std::vector<int> found;
  std::set<int> used;
  for (int e = 0; e < edges.count(); ++e) {
    if (!edges.on_boundary(e)) continue;
    const int label = mesh.boundary_label[edges.boundary_index[e]];
    if (std::find(labels.begin(), labels.end(), label) == labels.end())
      continue;
    found.push_back(e);
    used.insert(label);
  }
  for (int label : labels)
    if (!used.count(label))
      refuse("label ", label, " is on no boundary edge of the mesh");
  return found;
}

/// Closed loops start at a corner: at the smallest of their vertices where they turn
/// about as much as anywhere.
void start_at_corner(const Mesh& mesh, const Edges& edges,
                     std::vector<int>& loop) {
  std::vector<double> turn;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const int before = loop[(k + loop.size() - 1) % loop.size()];
    turn.push_back(angle_between(edge_vector(mesh, edges, before),
                                 edge_vector(mesh, edges, loop[k])));
  }
  const double sharpest = *std::max_element(turn.begin(), turn.end());
  const auto start = std::find_if(turn.begin(), turn.end(), [&](double angle) {
    return angle >= 0.9 * sharpest;
  });
  std::rotate(loop.begin(), loop.begin() + (start - turn.begin()), loop.end());
}

/// A curve has at least this many edges and turns by at most this angle between them;
/// other polygons are meant.
constexpr int fewest_edges = 5;
constexpr double largest_turn = 15 * M_PI / 180;

/// What a line takes its edges for: straight lines, straight lines and the chords of
/// curves, or the chords of one curve.
enum class Shape { polygon, parts, curve };

/// Edges ordered into chains: each starts where no edge ends, closed loops at a corner.
std::vector<std::vector<int>> chains(const Mesh& mesh, const Edges& edges,
                                     const std::vector<int>& boundary) {
  std::map<int, int> leaving;  // first vertex -> edge
  std::map<int, int> arriving;
  for (int e : boundary) {
    leaving[edges.vertices(0, e)] = e;
    arriving[edges.vertices(1, e)] = e;
  }
  std::vector<std::vector<int>> result;
  const auto follow = [&](int vertex) {
    result.emplace_back();
    for (auto next = leaving.find(vertex); next != leaving.end();
         next = leaving.find(vertex)) {
      result.back().push_back(next->second);
      vertex = edges.vertices(1, next->second);
      leaving.erase(next);
    }
  };
  std::vector<int> starts;
  for (const auto& [vertex, edge] : leaving)
    if (!arriving.count(vertex)) starts.push_back(vertex);
  for (int vertex : starts) follow(vertex);
  while (!leaving.empty()) {
    follow(leaving.begin()->first);
    start_at_corner(mesh, edges, result.back());
  }
  return result;
}

Matrix2Xd vertices_of(const Mesh& mesh, const Edges& edges,
                      const std::vector<int>& chain) {
  Matrix2Xd points(2, static_cast<Index>(chain.size()) + 1);
  points.col(0) = mesh.vertices.col(edges.vertices(0, chain.front()));
  for (std::size_t k = 0; k < chain.size(); ++k)
    points.col(static_cast<Index>(k) + 1) =
        mesh.vertices.col(edges.vertices(1, chain[k]));
  return points;
}

Matrix2Xd places_of(const Mesh& mesh, const Edges& edges,
                    const std::vector<int>& boundary) {
  Matrix2Xd points(2, 2 * static_cast<Index>(boundary.size()));
  for (std::size_t k = 0; k < boundary.size(); ++k)
    for (int end = 0; end < 2; ++end)
      points.col(2 * static_cast<Index>(k) + end) =
          mesh.place(edges.vertices(end, boundary[k]));
  return points;
}

/// Appends nodes and edges to a line.
class LineBuilder {
 public:
  LineBuilder(const Mesh& mesh, const Edges& edges, Shape shape)
      : mesh_(mesh), edges_(edges), shape_(shape) {}

  /// @param tolerance  of straight_runs
  void add_chain(const std::vector<int>& chain, double tolerance) {
    const Matrix2Xd points = vertices_of(mesh_, edges_, chain);
    const int first_node = static_cast<int>(vertex_.size()),
              edges = static_cast<int>(chain.size());
    if (shape_ == Shape::curve) {
      add_part(chain, 0, Matrix2Xd::Zero(2, edges + 1), false);
    } else {
      double turn = 0;  // over the last edge before
      for (const LinePart& part :
           line_parts(points, tolerance, largest_turn,
                      shape_ == Shape::polygon ? edges + 1 : fewest_edges)) {
        const Matrix2Xd normals = normals_of(
            points.middleCols(part.first, part.edges() + 1), part.straight);
        const double next_turn = angle_between(normals.col(0), normals.col(1));
        const bool one_curve = (turn > 0) != (next_turn > 0);
        add_part(chain, part.first, normals,
                 part.first > 0 && one_curve &&
                     goes_on(normals.col(0), turn + next_turn));
        turn = angle_between(normals.col(part.edges() - 1),
                             normals.col(part.edges()));
      }
    }
    const bool closed = edges > 1 && vertex_.back() == vertex_[first_node];
    if (closed &&
        (shape_ == Shape::curve ||
         goes_on(normal_[first_node],
                 angle_between(normal_[first_node], normal_[first_node + 1]))))
      join_loop(first_node);
  }

  ContactLine line() const {
    ContactLine line;
    const auto p = static_cast<Index>(vertex_.size()),
               m = static_cast<Index>(edge_.size());
    line.vertex = Map<const VectorXi>(vertex_.data(), p);
    line.abscissa = Map<const VectorXd>(abscissa_.data(), p);
    line.edge = Map<const VectorXi>(edge_.data(), m);
    line.length = Map<const VectorXd>(length_.data(), m);
    line.normal.resize(2, p);
    line.edge_node.resize(2, m);
    for (Index i = 0; i < p; ++i) line.normal.col(i) = normal_[i];
    for (Index e = 0; e < m; ++e) line.edge_node.col(e) = edge_node_[e];
    return line;
  }

 private:
  int add_node(int vertex, const Vector2d& normal) {
    vertex_.push_back(vertex);
    normal_.push_back(normal);
    abscissa_.push_back(arc_);
    return static_cast<int>(vertex_.size()) - 1;
  }

  /// Normals of a straight line, all that of its chord, or of a smooth curve.
  static Matrix2Xd normals_of(const Matrix2Xd& points, bool straight) {
    const Index last = points.cols() - 1;
    const bool closed = points.col(0) == points.col(last);
    const Matrix2Xd tangents =
        straight
            ? Matrix2Xd((points.col(last) - points.col(0))
                            .normalized()
                            .replicate(1, last + 1))
            : smooth_curve(points, closed && closes_smoothly(points)).tangents;
    Matrix2Xd normals(2, last + 1);
    normals << tangents.row(1), -tangents.row(0);
    return normals;
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
    int node = shared
                   ? static_cast<int>(vertex_.size()) - 1
                   : add_node(edges_.vertices(0, chain[first]), normals.col(0));
    if (normals.col(0) == normals.col(1)) normal_[node] = normals.col(0);
    for (Index k = 1; k < normals.cols(); ++k) {
      const int e = chain[first + k - 1];
      length_.push_back(edge_vector(mesh_, edges_, e).norm());
      arc_ += length_.back();
      const int next = add_node(edges_.vertices(1, e), normals.col(k));
      edge_.push_back(e);
      edge_node_.push_back({node, next});
      node = next;
    }
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
  for (const std::vector<int>& chain : chains(mesh, edges, boundary))
    builder.add_chain(chain, straight_tolerance(precision, size));
  ContactLine line = builder.line();
  line.precision = precision;
  return line;
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
      const Vector2d d = direction.col(node), x = mesh.place(line.vertex[node]);
      if (!d.allFinite() ||
          !(d.dot(edge_normal(mesh, edges, line.edge[e])) > 0))
        refuse("the contact direction (", d.x(), ", ", d.y(), ") at vertex ",
               line.vertex[node], " (", x.x(), ", ", x.y(),
               ") does not point out of the body");
    }
  line.normal = direction.colwise().normalized();
  return line;
}

std::vector<int> opposite_vertices(const ContactLine& line) {
  std::set<int> vertices;
  for (int i = 0; i < line.node_count(); ++i)
    visit_opposite(line, i,
                   [&](int vertex, double) { vertices.insert(vertex); });
  return {vertices.begin(), vertices.end()};
}

SparseMatrix contact_mass(const ContactLine& line) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        entries.emplace_back(line.edge_node(a, e), line.edge_node(b, e),
                             line.length[e] / (a == b ? 3 : 6));
  SparseMatrix mass(line.node_count(), line.node_count());
  mass.setFromTriplets(entries.begin(), entries.end());
  return mass;
}

Matrix2Xd contact_components(const ContactLine& line,
                             const Ref<const VectorXd>& field) {
  Matrix2Xd components(2, line.node_count());
  for (int i = 0; i < line.node_count(); ++i) {
    Vector2d value = field.segment<2>(2 * line.vertex[i]);
    visit_opposite(line, i, [&](int vertex, double weight) {
      value -= weight * field.segment<2>(2 * vertex);
    });
    components.col(i) << value.dot(line.normal.col(i)),
        value.dot(line.tangent(i));
  }
  return components;
}

}  // namespace ffcontact
