// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/displacement/admissible_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/estimate/bodies/edge_motions.hpp"
#include "ffcontact/estimate/bodies/smallest_change.hpp"
#include "ffcontact/interface/curve_directions.hpp"
#include "ffcontact/interface/facing_groups.hpp"

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
    return Matrix2Xd(change->reshaped(2, vertices_.size()));
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

  VectorXd penetration(const ContactLaw<2>& law) const {
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

  /// The same, and with them what faces those that cannot.
  /// @param left  penetration that is left
  template <class Left>
  void move_all(const VectorXd& penetration, const Left& left) {
    const std::vector<int> stuck = move_each(penetration);
    if (stuck.empty() || !line.against_a_body()) return;
    for (const std::vector<int>& group : facing_groups(line))
      if (meet(group, stuck)) move(group, left());
  }
};

/// How far the ends of an edge must go along their normals so that it keeps clear between
/// them, 0 where it does.
/// @param alone  whether each of them must do without the other
double depth_between(const ContactLine& line, const EdgeMotions& motions, int e,
                     bool alone) {
  const auto& [first, middle, second] = motions.normal;
  const double cosine = line.normal.col(line.edge_node(0, e))
                            .dot(line.normal.col(line.edge_node(1, e))),
               allowed =
                   std::sqrt(std::max(0.0, -first) * std::max(0.0, -second));
  if (middle <= allowed || cosine <= 0) return 0;
  return alone ? 2 * (middle - allowed) / cosine : middle / (1 + cosine);
}

/// The largest that the edges beside each node ask for [p].
VectorXd depths_between(const ContactLine& line, const LineMotions& motions,
                        bool alone) {
  VectorXd depths = VectorXd::Zero(line.node_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    if (!turns(line, e)) continue;
    const double depth = depth_between(line, motions.on(e), e, alone);
    for (const int node : line.edge_node.col(e))
      depths[node] = std::max(depths[node], depth);
  }
  return depths;
}

/// Where a quadratic that is not above 0 at its ends is the largest.
double highest_place(const QuadraticOnEdge& f) {
  const double rise = f.middle - f.first, fall = f.middle - f.second;
  return rise > 0 && fall > 0 ? rise / (rise + fall) : rise > 0 ? 1 : 0;
}

}  // namespace

VectorXd admissible_displacement(const ContactLine& line,
                                 const ContactLaw<2>& law,
                                 const Ref<const VectorXd>& displacement,
                                 const Flags& prescribed) {
  const double largest = farthest * largest_displacement(law, displacement);
  Lowered lowered{line, prescribed, nodes_of_vertices(line), largest,
                  displacement};
  lowered.move_all(lowered.penetration(law),
                   [&] { return lowered.penetration(law); });
  return lowered.u;
}

VectorXd cleared_between_nodes(const ContactLine& line,
                               const ContactLaw<2>& law,
                               const Ref<const VectorXd>& displacement,
                               const Flags& prescribed) {
  constexpr int most_passes = 10;
  if (!turns(line)) return displacement;
  const double largest = farthest * largest_displacement(law, displacement);
  Lowered lowered{line, prescribed, nodes_of_vertices(line), largest,
                  displacement};
  for (int pass = 0; pass < most_passes; ++pass) {
    const LineMotions motions(line, law, lowered.u);
    const VectorXd depths = depths_between(line, motions, pass > 0);
    if (depths.isZero(0)) break;
    lowered.move_all(depths, [&] { return depths; });
  }
  return lowered.u;
}

DeepestNode deepest_node(const ContactLine& line, const ContactLaw<2>& law,
                         const Ref<const VectorXd>& displacement) {
  const LineMotions motions(line, law, displacement);
  DeepestNode deepest;
  const auto note = [&deepest](double depth, int node) {
    if (depth > deepest.depth) deepest = {depth, node};
  };
  const Matrix2Xd w = displacement_against_foundation(line, law, displacement);
  for (int i = 0; i < line.node_count(); ++i)
    if (law.is_bonded(i)) note(w.col(i).norm(), i);
  for (int e = 0; e < line.edge_count(); ++e) {
    if (law.is_bonded(line.edge_node(0, e))) continue;
    const QuadraticOnEdge wn = motions.on(e).normal;
    for (const double s : {0.0, highest_place(wn), 1.0})
      note(wn(s), line.edge_node(s > 0.5 ? 1 : 0, e));
  }
  return deepest;
}

}  // namespace ffcontact
