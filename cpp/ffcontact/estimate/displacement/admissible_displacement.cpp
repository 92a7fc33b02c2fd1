// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/displacement/admissible_displacement.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/unions.hpp"
#include "ffcontact/estimate/bodies/smallest_change.hpp"

namespace ffcontact {

namespace {

using NodesOfVertices = std::map<int, std::vector<int>>;

/// Some vertices that move together, and the nodes on them.
class MovingVertices {
 public:
  MovingVertices(const ContactLine& line,
                 const NodesOfVertices& nodes_of_vertex,
                 const std::vector<int>& vertices)
      : line_(line), vertices_(vertices) {
    for (const int v : vertices)
      if (const auto nodes = nodes_of_vertex.find(v);
          nodes != nodes_of_vertex.end())
        nodes_.insert(nodes_.end(), nodes->second.begin(), nodes->second.end());
  }

  /// The smallest change of the free components after which no node penetrates [2 x
  /// vertices]; nothing if there is none.
  /// @param penetration  u_n - gap of all nodes of the line
  /// @param largest      change of a component
  std::optional<Matrix2Xd> lowering(const VectorXd& penetration,
                                    const Flags& prescribed,
                                    double largest) const {
    const auto change =
        smallest_change(away(prescribed), penetration(nodes_), largest);
    if (!change) return std::nullopt;
    return Matrix2Xd(change->reshaped(2, change->size() / 2));
  }

 private:
  /// - [u] . n of each node for the free components [nodes x 2 vertices].
  MatrixXd away(const Flags& prescribed) const {
    MatrixXd rows = MatrixXd::Zero(nodes_.size(), 2 * vertices_.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      add(k, line_.vertex[nodes_[k]], -1, rows);
      visit_opposite(line_, nodes_[k], [&](int vertex, double weight) {
        add(k, vertex, weight, rows);
      });
    }
    if (!prescribed.empty()) hold(prescribed, rows);
    return (rows.array().abs() < least_component).select(0, rows);
  }

  void hold(const Flags& prescribed, MatrixXd& rows) const {
    for (std::size_t j = 0; j < vertices_.size(); ++j)
      for (int c = 0; c < 2; ++c)
        if (prescribed[2 * vertices_[j] + c]) rows.col(2 * j + c).setZero();
  }

  void add(std::size_t k, int vertex, double weight, MatrixXd& rows) const {
    const auto place = std::find(vertices_.begin(), vertices_.end(), vertex);
    if (place == vertices_.end()) return;
    rows.block<1, 2>(k, 2 * (place - vertices_.begin())) +=
        weight * line_.normal.col(nodes_[k]).transpose();
  }

  const ContactLine& line_;
  const std::vector<int>& vertices_;
  std::vector<int> nodes_;
};

NodesOfVertices nodes_of_vertices(const ContactLine& line) {
  NodesOfVertices nodes;
  for (int i = 0; i < line.node_count(); ++i)
    nodes[line.vertex[i]].push_back(i);
  return nodes;
}

/// The vertices that depend on each other on a line: that of each node and what it faces,
/// joined where nodes share a vertex.
std::vector<std::vector<int>> contact_groups(const ContactLine& line) {
  const std::vector<int> vertices = contact_vertices(line);
  Unions joined(1 + *std::max_element(vertices.begin(), vertices.end()));
  for (int i = 0; i < line.node_count(); ++i)
    visit_opposite(line, i, [&](int vertex, double) {
      joined.join(line.vertex[i], vertex);
    });
  std::vector<std::vector<int>> groups;
  for (const auto& [root, set] : joined.sets_of(vertices))
    groups.emplace_back(set.begin(), set.end());
  return groups;
}

bool meet(const std::vector<int>& some, const std::vector<int>& others) {
  return std::find_first_of(some.begin(), some.end(), others.begin(),
                            others.end()) != some.end();
}

/// A displacement on its way out of the foundation.
struct Lowered {
  const ContactLine& line;
  const Flags& prescribed;
  const NodesOfVertices nodes_of_vertex;
  double largest;  ///< change of a component
  VectorXd u;

  VectorXd penetration(const ContactLaw& law) const {
    return displacement_against_foundation(line, law, u).row(0);
  }

  /// Moves some vertices together. @return whether they can go where no node on them
  /// penetrates
  bool move(const std::vector<int>& vertices, const VectorXd& penetration) {
    const MovingVertices moving(line, nodes_of_vertex, vertices);
    const auto change = moving.lowering(penetration, prescribed, largest);
    if (!change) return false;
    for (std::size_t j = 0; j < vertices.size(); ++j)
      u.segment<2>(2 * vertices[j]) += change->col(j);
    return true;
  }

  /// Moves all vertices, each by itself. @return those that cannot
  std::vector<int> move_each(const VectorXd& penetration) {
    std::vector<int> stuck;
    for (const auto& [vertex, nodes] : nodes_of_vertex)
      if (!move({vertex}, penetration)) stuck.push_back(vertex);
    return stuck;
  }
};

}  // namespace

VectorXd admissible_displacement(const ContactLine& line, const ContactLaw& law,
                                 const Ref<const VectorXd>& displacement,
                                 const Flags& prescribed) {
  const double largest = farthest * largest_displacement(law, displacement);
  Lowered lowered{line, prescribed, nodes_of_vertices(line), largest,
                  displacement};
  const std::vector<int> stuck = lowered.move_each(lowered.penetration(law));
  if (stuck.empty() || !line.against_a_body()) return lowered.u;
  for (const std::vector<int>& group : contact_groups(line))
    if (meet(group, stuck)) lowered.move(group, lowered.penetration(law));
  return lowered.u;
}

DeepestNode deepest_node(const ContactLine& line, const ContactLaw& law,
                         const Ref<const VectorXd>& displacement) {
  const Matrix2Xd w = displacement_against_foundation(line, law, displacement);
  DeepestNode deepest;
  deepest.depth = std::max(0.0, w.row(0).maxCoeff(&deepest.node));
  return deepest;
}

}  // namespace ffcontact
