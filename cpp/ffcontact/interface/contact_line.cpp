// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/contact_line.hpp"

#include <algorithm>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/boundary_chains.hpp"
#include "ffcontact/mesh/straight_runs.hpp"
#include "ffcontact/mesh/turns.hpp"

namespace ffcontact {

namespace {

using Chain = std::vector<int>;

/// Normals at the points of a straight line, all that of its chord.
Matrix2Xd straight_normals(const Matrix2Xd& points) {
  const Vector2d chord = points.col(points.cols() - 1) - points.col(0);
  return turned_right(chord.normalized()).replicate(1, points.cols());
}

/// Appends nodes and edges to a line.
class LineBuilder {
 public:
  /// @param curves  nullptr for one node a vertex, whatever the shape
  LineBuilder(const Mesh& mesh, const Edges& edges,
              const BoundaryCurves* curves)
      : mesh_(mesh), edges_(edges), curves_(curves) {}

  /// @param tolerance  of straight_runs
  void add_chain(const Chain& chain, double tolerance) {
    const int first_node = start_of_chain_ = count_of(vertex_);
    if (curves_)
      add_parts(chain, tolerance);
    else
      add_part(chain, Matrix2Xd::Zero(2, count_of(chain) + 1), false);
    if (count_of(chain) > 1 && is_loop_from(first_node)) join_loop(first_node);
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
  /// Straight lines and smooth curves, each from the node that the one before ends at
  /// where the line goes on.
  void add_parts(const Chain& chain, double tolerance) {
    for (auto first = chain.begin(); first != chain.end();) {
      const Chord<2>* chord = curves_->chord(*first);
      const auto last = chord ? end_of_curve(first, chain.end())
                              : std::find_if(first, chain.end(), [&](int e) {
                                  return curves_->chord(e);
                                });
      const Chain part(first, last);
      if (chord)
        add_curve(part);
      else
        add_straight_runs(part, tolerance);
      first = last;
    }
  }

  Chain::const_iterator end_of_curve(Chain::const_iterator edge,
                                     Chain::const_iterator end) const {
    const Chord<2>* chord = curves_->chord(*edge);
    while (++edge != end) {
      const Chord<2>* next = curves_->chord(*edge);
      if (!next || next->first_tangent != chord->last_tangent) break;
      chord = next;
    }
    return edge;
  }

  void add_curve(const Chain& part) {
    Matrix2Xd normals(2, count_of(part) + 1);
    normals.col(0) = turned_right(curves_->chord(part[0])->first_tangent);
    for (int k = 0; k < count_of(part); ++k)
      normals.col(k + 1) = turned_right(curves_->chord(part[k])->last_tangent);
    const bool shared = !after_curve_ && shares_a_node(normals, 0);
    add_part(part, normals, shared);
    after_curve_ = true;
    last_turn_ = turn_after(normals, count_of(part) - 1);
  }

  void add_straight_runs(const Chain& part, double tolerance) {
    const Matrix2Xd points = points_of(mesh_, edges_, part);
    const std::vector<int> runs = straight_runs(points, tolerance);
    for (std::size_t r = 0; r + 1 < runs.size(); ++r) {
      const int first = runs[r], count = runs[r + 1] - first;
      const Matrix2Xd normals =
          straight_normals(points.middleCols(first, count + 1));
      const bool shared = after_curve_ && shares_a_node(normals, last_turn_);
      add_part({part.begin() + first, part.begin() + runs[r + 1]}, normals,
               shared);
      after_curve_ = false;
    }
  }

  static double turn_after(const Matrix2Xd& normals, Index k) {
    return angle_between(normals.col(k), normals.col(k + 1));
  }

  /// Whether a part goes on from the one before, one of both a curve.
  /// @param turn  of the part before over its last edge
  bool shares_a_node(const Matrix2Xd& normals, double turn) const {
    return count_of(vertex_) > start_of_chain_ &&
           goes_on(normals.col(0), turn + turn_after(normals, 0));
  }

  /// Whether the chain that began at a node ends there as one line.
  bool is_loop_from(int node) const {
    if (vertex_.back() != vertex_[node]) return false;
    if (!curves_) return true;
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
    constexpr double rounding = 1e-9;
    return angle_between(normal_.back(), normal) < 0.5 * turn + rounding;
  }

  /// @param normals  at the vertices of the part
  /// @param shared  the last node so far is the first one of the part as well; it has the
  ///                normal of the straight one of both
  void add_part(const Chain& part, const Matrix2Xd& normals, bool shared) {
    if (!shared) add_node(edges_.vertices(0, part[0]), normals.col(0));
    int node = count_of(vertex_) - 1;
    if (normals.col(0) == normals.col(1)) normal_[node] = normals.col(0);
    for (Index k = 1; k < normals.cols(); ++k)
      node = add_edge(part[k - 1], node, normals.col(k));
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
  const BoundaryCurves* curves_;
  std::vector<int> vertex_, edge_;
  std::vector<Vector2d> normal_;
  std::vector<Vector2i> edge_node_;
  std::vector<double> abscissa_, length_;
  double arc_ = 0;
  int start_of_chain_ = 0;  ///< node
  bool after_curve_ = false;
  double last_turn_ = 0;  ///< of the curve before over its last edge
};

ContactLine built_line(const Mesh& mesh, const Edges& edges,
                       const std::vector<int>& labels,
                       const BoundaryCurves* curves) {
  const std::vector<int> boundary = labelled_boundary(mesh, edges, labels);
  const double size = extent(mesh.vertices);
  const double precision =
      coordinate_precision(places_of(mesh, edges, boundary), size);
  LineBuilder builder(mesh, edges, curves);
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
                         const std::vector<int>& labels,
                         const BoundaryCurves& curves) {
  return built_line(mesh, edges, labels, &curves);
}

ContactLine smooth_contact_line(const Mesh& mesh, const Edges& edges,
                                const std::vector<int>& labels) {
  ContactLine line = built_line(mesh, edges, labels, nullptr);
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
