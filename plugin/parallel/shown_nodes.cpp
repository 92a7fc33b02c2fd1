// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/shown_nodes.hpp"

#include <algorithm>
#include <map>

#include "ffcontact/base/packed.hpp"

namespace ffcontact::plugin {

namespace {

/// The pair of bodies that a node is of.
int pair_of(const std::vector<long>& first_node, int node) {
  return static_cast<int>(
             std::upper_bound(first_node.begin(), first_node.end(), node) -
             first_node.begin()) -
         1;
}

/// The vertices of a part by their numbers in the whole body.
template <int dim>
std::vector<std::map<long, long>> own_numbers(const SharedBodies<dim>& bodies,
                                              int rank) {
  std::vector<std::map<long, long>> own;
  for (const MeshParts<dim>& parts : bodies.parts) {
    own.emplace_back();
    for (int v : parts.vertex[rank])
      own.back().emplace(v, static_cast<long>(own.back().size()));
  }
  return own;
}

/// The nodes of a process in the problem, and their vertices in its parts.
struct NodesOfProcess {
  std::vector<int> node;
  std::vector<long> own_vertex;
};

template <int dim>
NodesOfProcess nodes_of(const ContactProblem<dim>& problem,
                        const SharedBodies<dim>& bodies, int rank) {
  const auto own = own_numbers(bodies, rank);
  NodesOfProcess nodes;
  for (int i = 0; i < count_of(problem.own_vertex); ++i) {
    // the body whose vertices those of the node are
    const auto& of_body =
        own[problem.body_of_pair[pair_of(problem.first_node, i)]];
    const auto found = of_body.find(problem.own_vertex[i]);
    if (found == of_body.end()) continue;
    nodes.node.push_back(i);
    nodes.own_vertex.push_back(found->second);
  }
  return nodes;
}

template <int dim>
ShownNodes numbered(const ContactProblem<dim>& problem,
                    const NodesOfProcess& nodes) {
  ShownNodes shown;
  shown.own_vertex = nodes.own_vertex;
  shown.side = problem.side;
  for (long first : problem.first_node)
    shown.first_node.push_back(
        std::lower_bound(nodes.node.begin(), nodes.node.end(), first) -
        nodes.node.begin());
  return shown;
}

NodalResults chosen(const NodalResults& all, const std::vector<int>& nodes) {
  NodalResults results;
  results.values = all.values(nodes, Eigen::all);
  for (int node : nodes) results.state.push_back(all.state[node]);
  return results;
}

void put_abscissa(const ContactProblem<2>& problem,
                  const std::vector<int>& nodes, ShownNodes& shown) {
  shown.abscissa = problem.abscissa(nodes);
}
void put_abscissa(const ContactProblem<3>&, const std::vector<int>&,
                  ShownNodes&) {}

}  // namespace

template <int d>
ShownNodes shown_nodes(const ContactProblem<d>& problem,
                       const SharedBodies<d>& bodies, int rank,
                       const NodalResults* solved) {
  const NodesOfProcess nodes = nodes_of(problem, bodies, rank);
  ShownNodes shown = numbered(problem, nodes);
  put_abscissa(problem, nodes.node, shown);
  shown.normal = problem.own_normals()(Eigen::all, nodes.node);
  if (solved) shown.solved = chosen(*solved, nodes.node);
  return shown;
}

template ShownNodes shown_nodes(const ContactProblem<2>&,
                                const SharedBodies<2>&, int,
                                const NodalResults*);
template ShownNodes shown_nodes(const ContactProblem<3>&,
                                const SharedBodies<3>&, int,
                                const NodalResults*);

void put(const ShownNodes& nodes, Packet& packet) {
  packet.put(nodes.own_vertex).put(nodes.first_node).put(nodes.side);
  packet.put(nodes.abscissa).put(nodes.normal).put(nodes.solved.has_value());
  if (nodes.solved) packet.put(nodes.solved->values).put(nodes.solved->state);
}

ShownNodes nodes_in(Packet& packet) {
  ShownNodes nodes;
  nodes.own_vertex = packet.take<std::vector<long>>();
  nodes.first_node = packet.take<std::vector<long>>();
  nodes.side = packet.take<std::vector<long>>();
  nodes.abscissa = packet.take<VectorXd>();
  nodes.normal = packet.take<MatrixXd>();
  if (!packet.take<bool>()) return nodes;
  nodes.solved.emplace();
  nodes.solved->values = packet.take<MatrixXd>();
  nodes.solved->state = packet.take<std::vector<long>>();
  return nodes;
}

}  // namespace ffcontact::plugin
