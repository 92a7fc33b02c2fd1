// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/constant_ends.hpp"

#include <utility>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/interface/pairing/opposite_projection.hpp"

namespace ffcontact {

namespace {

/// How many edges each node is an end of.
VectorXi edges_at_nodes(const ContactLine& line) {
  VectorXi count = VectorXi::Zero(line.node_count());
  for (int node : line.edge_node.reshaped()) ++count[node];
  return count;
}

/// Is an edge the first or the last of a line, and another one takes its density? The last
/// of two edges has its own: two nodes hold the moment of a body.
bool takes_density(const ContactLine& line, const VectorXi& count, int e) {
  const Vector2i nodes = line.edge_node.col(e);
  const bool begins = count[nodes[0]] == 1, ends = count[nodes[1]] == 1;
  if (begins) return count[nodes[1]] == 2;
  return ends && count[nodes[0]] == 2 && count[line.edge_node(0, e - 1)] > 1;
}

ContactLine without_unused_nodes(ContactLine line) {
  const VectorXi count = edges_at_nodes(line);
  std::vector<int> used;
  VectorXi number(line.node_count());
  for (int i = 0; i < line.node_count(); ++i)
    if (count[i] > 0) {
      number[i] = count_of(used);
      used.push_back(i);
    }
  for (int& node : line.edge_node.reshaped()) node = number[node];
  line.vertex = line.vertex(used).eval();
  line.normal = line.normal(Eigen::all, used).eval();
  line.abscissa = line.abscissa(used).eval();
  return line;
}

}  // namespace

ContactLine with_constant_ends(const Mesh& mesh, const Edges& edges,
                               const ContactLine& line) {
  if (line.matches()) return line;
  ContactLine result = line;
  const VectorXi count = edges_at_nodes(line);
  for (int e = 0; e < line.edge_count(); ++e)
    if (takes_density(line, count, e))
      for (int end = 0; end < 2; ++end)
        if (count[line.edge_node(end, e)] == 1)
          result.edge_node(end, e) = line.edge_node(1 - end, e);
  return with_opposite(mesh, edges, without_unused_nodes(std::move(result)));
}

ContactLine without_ends(const Mesh& mesh, const Edges& edges,
                         const ContactLine& line, const Flags& held) {
  ContactLine result = line;
  const VectorXi count = edges_at_nodes(line);
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) {
      const int node = line.edge_node(end, e);
      if (count[node] == 1 && held[line.vertex[node]] &&
          result.edge_node(0, e) != result.edge_node(1, e))
        result.edge_node(end, e) = line.edge_node(1 - end, e);
    }
  return with_opposite(mesh, edges, without_unused_nodes(std::move(result)));
}

}  // namespace ffcontact
