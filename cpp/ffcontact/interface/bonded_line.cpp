// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/bonded_line.hpp"

#include <map>
#include <numeric>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/interface/curve_directions.hpp"

namespace ffcontact {

namespace {

/// The normal of the straight line that each mesh edge is a part of.
std::map<int, Vector2d> straight_normals(const Mesh& mesh, const Edges& edges,
                                         const std::vector<int>& labels) {
  const ContactLine line = contact_line(mesh, edges, labels);
  std::map<int, Vector2d> normals;
  for (int e = 0; e < line.edge_count(); ++e)
    normals.emplace(line.edge[e], line.edge_normal(e));
  return normals;
}

bool bonded_and_turns(const ContactLine& line, const Flags& bonded, int e) {
  return !bonded.empty() && bonded[line.edge_node(0, e)] && turns(line, e);
}

/// Numbers of nodes of their own for bonded edges that turn.
class NodesOfEdges {
 public:
  NodesOfEdges(const ContactLine& line, const Flags& bonded)
      : parent_(line.node_count()), is_taken_(line.node_count(), 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (int e = 0; e < line.edge_count(); ++e)
      if (!bonded_and_turns(line, bonded, e))
        for (int node : line.edge_node.col(e)) is_taken_[node] = 1;
  }

  /// The node itself, once, or else a new one at its place.
  int own(int node) {
    if (!is_taken_[node]) {
      is_taken_[node] = 1;
      return node;
    }
    parent_.push_back(node);
    return count_of(parent_) - 1;
  }

  const std::vector<int>& parents() const { return parent_; }

 private:
  std::vector<int> parent_;
  Flags is_taken_;  ///< of the given nodes
};

}  // namespace

ContactLine bonded_line(const Mesh& mesh, const Edges& edges,
                        const std::vector<int>& labels) {
  ContactLine line = smooth_contact_line(mesh, edges, labels);
  const std::map<int, Vector2d> normals = straight_normals(mesh, edges, labels);
  Flags is_met(line.node_count(), 0);
  for (int e = 0; e < line.edge_count(); ++e)
    for (int node : line.edge_node.col(e)) {
      const Vector2d& n =
          entry_of(normals, line.edge[e], "normal of a straight line");
      auto at_node = line.normal.col(node);
      if (is_met[node] && at_node != n)
        at_node = (at_node + n).normalized();
      else
        at_node = n;
      is_met[node] = 1;
    }
  return line;
}

bool bonded_part_turns(const ContactLine& line, const Flags& bonded) {
  for (int e = 0; e < line.edge_count(); ++e)
    if (bonded_and_turns(line, bonded, e)) return true;
  return false;
}

UnturnedLine unturned_line(const Mesh& mesh, const Edges& edges,
                           const ContactLine& line, const Flags& bonded) {
  NodesOfEdges nodes(line, bonded);
  UnturnedLine result{line, {}};
  std::map<int, Vector2d> normals;
  for (int e = 0; e < line.edge_count(); ++e) {
    if (!bonded_and_turns(line, bonded, e)) continue;
    for (int& node : result.line.edge_node.col(e)) {
      node = nodes.own(node);
      normals[node] = edge_normal(mesh, edges, line.edge[e]);
    }
  }
  const std::vector<int>& parents = nodes.parents();
  result.parent = packed(parents);
  result.line.vertex = line.vertex(parents);
  result.line.abscissa = line.abscissa(parents);
  result.line.normal = line.normal(Eigen::all, parents);
  for (const auto& [node, normal] : normals)
    result.line.normal.col(node) = normal;
  result.line.opposite = rows_of(line.opposite, parents);
  return result;
}

}  // namespace ffcontact
