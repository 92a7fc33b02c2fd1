// SPDX-License-Identifier: GPL-3.0-or-later
#include "shown_nodes.hpp"

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

/// The body whose vertices those of a node are.
template <int dim>
int body_of_node(const std::vector<long>& first_node,
                 const SharedBodies<dim>& bodies, int node) {
  return bodies.parts.size() == 1 ? 0 : pair_of(first_node, node);
}

template <class Problem, int dim>
ShownNodes numbered_nodes(const Problem& problem,
                          const SharedBodies<dim>& bodies, int rank) {
  const auto own = own_numbers(bodies, rank);
  ShownNodes shown;
  shown.side = problem.side;
  shown.first_node.assign(problem.first_node.size(), 0);
  for (int node : nodes_of(problem, bodies, rank)) {
    const int body = body_of_node(problem.first_node, bodies, node);
    shown.own_vertex.push_back(own[body].at(problem.own_vertex[node]));
    for (auto k = pair_of(problem.first_node, node) + 1;
         k < count_of(problem.first_node); ++k)
      ++shown.first_node[k];
  }
  return shown;
}

std::vector<long> at(const std::vector<long>& values,
                     const std::vector<int>& nodes) {
  std::vector<long> chosen;
  for (int node : nodes) chosen.push_back(values[node]);
  return chosen;
}

template <class Results, class Arrays>
void put(const Results& results, const Arrays& arrays, Packet& packet) {
  for (auto array : arrays) packet.put(results.*array);
  packet.put(results.state);
}

template <class Results, class Arrays>
void take(Packet& packet, const Arrays& arrays, Results& results) {
  for (auto array : arrays) results.*array = packet.take<VectorXd>();
  results.state = packet.take<std::vector<long>>();
}

}  // namespace

template <class Problem, int dim>
std::vector<int> nodes_of(const Problem& problem,
                          const SharedBodies<dim>& bodies, int rank) {
  const auto own = own_numbers(bodies, rank);
  std::vector<int> nodes;
  for (int node = 0; node < count_of(problem.own_vertex); ++node)
    if (own[body_of_node(problem.first_node, bodies, node)].count(
            problem.own_vertex[node]) > 0)
      nodes.push_back(node);
  return nodes;
}

template std::vector<int> nodes_of(const ContactProblem&,
                                   const SharedBodies<2>&, int);
template std::vector<int> nodes_of(const SolidProblem&, const SharedBodies<3>&,
                                   int);

ShownNodes shown_nodes(const ContactProblem& problem,
                       const SharedBodies<2>& bodies, int rank) {
  ShownNodes shown = numbered_nodes(problem, bodies, rank);
  shown.abscissa = problem.abscissa(nodes_of(problem, bodies, rank));
  return shown;
}

ShownNodes shown_nodes(const SolidProblem& problem,
                       const SharedBodies<3>& bodies, int rank) {
  ShownNodes shown = numbered_nodes(problem, bodies, rank);
  shown.normal =
      problem.surface.normal(Eigen::all, nodes_of(problem, bodies, rank));
  return shown;
}

void take(const NodalResults& all, const std::vector<int>& nodes,
          ShownNodes& shown) {
  for (auto array : arrays_of_plane_bodies)
    shown.plane.*array = (all.*array)(nodes);
  shown.plane.state = at(all.state, nodes);
  shown.solved = true;
}

void take(const SolidResults& all, const std::vector<int>& nodes,
          ShownNodes& shown) {
  for (auto array : arrays_of_solids) shown.solid.*array = (all.*array)(nodes);
  shown.solid.state = at(all.state, nodes);
  shown.solved = true;
}

void put(const ShownNodes& nodes, Packet& packet) {
  packet.put(nodes.own_vertex).put(nodes.first_node).put(nodes.side);
  packet.put(nodes.abscissa).put(MatrixXd(nodes.normal)).put(nodes.solved);
  put(nodes.plane, arrays_of_plane_bodies, packet);
  put(nodes.solid, arrays_of_solids, packet);
}

ShownNodes nodes_in(Packet& packet) {
  ShownNodes nodes;
  nodes.own_vertex = packet.take<std::vector<long>>();
  nodes.first_node = packet.take<std::vector<long>>();
  nodes.side = packet.take<std::vector<long>>();
  nodes.abscissa = packet.take<VectorXd>();
  nodes.normal = packet.take<MatrixXd>();
  nodes.solved = packet.take<bool>();
  take(packet, arrays_of_plane_bodies, nodes.plane);
  take(packet, arrays_of_solids, nodes.solid);
  return nodes;
}

}  // namespace ffcontact::plugin
