// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/contact_line.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// Two edges are on one straight line when the sine of the angle between them is below this.
constexpr double straight = 1e-8;

std::vector<int> labelled_boundary(const Mesh& mesh, const Edges& edges, const std::vector<int>& labels) {
  if (labels.empty()) refuse("no contact label is given");
  std::vector<int> found;
  std::set<int> used;
  for (int e = 0; e < edges.count(); ++e) {
    if (!edges.on_boundary(e)) continue;
    const int label = mesh.boundary_label[edges.boundary_index[e]];
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) continue;
    found.push_back(e);
    used.insert(label);
  }
  for (int label : labels)
    if (!used.count(label)) refuse("label ", label, " is on no boundary edge of the mesh");
  return found;
}

/// Edges ordered into chains: each starts where no edge ends, closed loops at their smallest vertex.
std::vector<std::vector<int>> chains(const Edges& edges, const std::vector<int>& boundary) {
  std::map<int, int> leaving;  // first vertex -> edge
  std::map<int, int> arriving;
  for (int e : boundary) {
    leaving[edges.vertices(0, e)] = e;
    arriving[edges.vertices(1, e)] = e;
  }
  std::vector<std::vector<int>> result;
  const auto follow = [&](int vertex) {
    result.emplace_back();
    for (auto next = leaving.find(vertex); next != leaving.end(); next = leaving.find(vertex)) {
      result.back().push_back(next->second);
      vertex = edges.vertices(1, next->second);
      leaving.erase(next);
    }
  };
  std::vector<int> starts;
  for (const auto& [vertex, edge] : leaving)
    if (!arriving.count(vertex)) starts.push_back(vertex);
  for (int vertex : starts) follow(vertex);
  while (!leaving.empty()) follow(leaving.begin()->first);
  return result;
}

double sine_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Appends nodes and edges to a line.
class LineBuilder {
 public:
  LineBuilder(const Mesh& mesh, const Edges& edges, bool smooth) : mesh_(mesh), edges_(edges), smooth_(smooth) {}

  void add_chain(const std::vector<int>& chain) {
    const std::size_t first_edge = length_.size();
    const int first_node = static_cast<int>(vertex_.size());
    for (int e : chain) {
      const Eigen::Vector2d n = edge_normal(mesh_, edges_, e);
      const bool new_line = e == chain.front() || turns(normal_.back(), n);
      const int start = new_line ? add_node(edges_.vertices(0, e), n) : static_cast<int>(vertex_.size()) - 1;
      length_.push_back(edge_vector(mesh_, edges_, e).norm());
      arc_ += length_.back();
      const int end = add_node(edges_.vertices(1, e), normal_[start]);
      edge_.push_back(e);
      edge_node_.push_back({start, end});
    }
    join_loop(first_edge, first_node);
  }

  ContactLine line() const {
    ContactLine line;
    const auto p = static_cast<Eigen::Index>(vertex_.size()), m = static_cast<Eigen::Index>(edge_.size());
    line.vertex = Eigen::Map<const Eigen::VectorXi>(vertex_.data(), p);
    line.abscissa = Eigen::Map<const Eigen::VectorXd>(abscissa_.data(), p);
    line.edge = Eigen::Map<const Eigen::VectorXi>(edge_.data(), m);
    line.length = Eigen::Map<const Eigen::VectorXd>(length_.data(), m);
    line.normal.resize(2, p);
    line.edge_node.resize(2, m);
    for (Eigen::Index i = 0; i < p; ++i) line.normal.col(i) = normal_[i];
    for (Eigen::Index e = 0; e < m; ++e) line.edge_node.col(e) = edge_node_[e];
    return line;
  }

 private:
  int add_node(int vertex, const Eigen::Vector2d& normal) {
    vertex_.push_back(vertex);
    normal_.push_back(normal);
    abscissa_.push_back(arc_);
    return static_cast<int>(vertex_.size()) - 1;
  }

  bool turns(const Eigen::Vector2d& before, const Eigen::Vector2d& after) const {
    return !smooth_ && std::abs(sine_between(before, after)) > straight;
  }

  /// A closed loop that does not turn where it closes shares its first node.
  void join_loop(std::size_t first_edge, int first_node) {
    if (length_.size() - first_edge < 2 || vertex_.back() != vertex_[first_node]) return;
    if (turns(normal_.back(), normal_[first_node])) return;
    edge_node_.back()[1] = first_node;
    vertex_.pop_back();
    normal_.pop_back();
    abscissa_.pop_back();
  }

  const Mesh& mesh_;
  const Edges& edges_;
  const bool smooth_;
  std::vector<int> vertex_, edge_;
  std::vector<Eigen::Vector2d> normal_;
  std::vector<Eigen::Vector2i> edge_node_;
  std::vector<double> abscissa_, length_;
  double arc_ = 0;
};

ContactLine built_line(const Mesh& mesh, const Edges& edges, const std::vector<int>& labels, bool smooth) {
  LineBuilder builder(mesh, edges, smooth);
  for (const std::vector<int>& chain : chains(edges, labelled_boundary(mesh, edges, labels))) builder.add_chain(chain);
  return builder.line();
}

}  // namespace

ContactLine contact_line(const Mesh& mesh, const Edges& edges, const std::vector<int>& labels) {
  return built_line(mesh, edges, labels, false);
}

ContactLine smooth_contact_line(const Mesh& mesh, const Edges& edges, const std::vector<int>& labels) {
  ContactLine line = built_line(mesh, edges, labels, true);
  line.normal.setZero();
  for (int e = 0; e < line.edge_count(); ++e)
    for (int node : line.edge_node.col(e)) line.normal.col(node) += edge_normal(mesh, edges, line.edge[e]);
  line.normal.colwise().normalize();
  return line;
}

ContactLine along_directions(const Mesh& mesh, const Edges& edges, ContactLine line,
                             const Eigen::Ref<const Eigen::Matrix2Xd>& direction) {
  require_size("contact directions", direction.cols(), line.node_count());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int node : line.edge_node.col(e)) {
      const Eigen::Vector2d d = direction.col(node), x = mesh.vertices.col(line.vertex[node]);
      if (!d.allFinite() || !(d.dot(edge_normal(mesh, edges, line.edge[e])) > 0))
        refuse("the contact direction (", d.x(), ", ", d.y(), ") at vertex ", line.vertex[node], " (", x.x(), ", ",
               x.y(), ") does not point out of the body");
    }
  line.normal = direction.colwise().normalized();
  return line;
}

std::vector<int> opposite_vertices(const ContactLine& line) {
  std::set<int> vertices;
  for (int i = 0; i < line.node_count(); ++i)
    visit_opposite(line, i, [&](int vertex, double) { vertices.insert(vertex); });
  return {vertices.begin(), vertices.end()};
}

Eigen::SparseMatrix<double> contact_mass(const ContactLine& line) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        entries.emplace_back(line.edge_node(a, e), line.edge_node(b, e), line.length[e] / (a == b ? 3 : 6));
  Eigen::SparseMatrix<double> mass(line.node_count(), line.node_count());
  mass.setFromTriplets(entries.begin(), entries.end());
  return mass;
}

Eigen::Matrix2Xd contact_components(const ContactLine& line, const Eigen::Ref<const Eigen::VectorXd>& field) {
  Eigen::Matrix2Xd components(2, line.node_count());
  for (int i = 0; i < line.node_count(); ++i) {
    Eigen::Vector2d value = field.segment<2>(2 * line.vertex[i]);
    visit_opposite(line, i, [&](int vertex, double weight) { value -= weight * field.segment<2>(2 * vertex); });
    components.col(i) << value.dot(line.normal.col(i)), value.dot(line.tangent(i));
  }
  return components;
}

}  // namespace ffcontact
