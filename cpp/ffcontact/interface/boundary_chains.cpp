// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/boundary_chains.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/labelled_facets.hpp"
#include "ffcontact/mesh/straight_runs.hpp"

namespace ffcontact {

namespace {

using Chain = std::vector<int>;
using EdgeByVertex = std::map<int, int>;

/// Angles by which a loop turns at the first vertex of each edge.
std::vector<double> turns_of(const Mesh& mesh, const Edges& edges,
                             const Chain& loop) {
  std::vector<double> turns;
  int before = loop.back();
  for (int edge : loop) {
    turns.push_back(angle_between(edge_vector(mesh, edges, before),
                                  edge_vector(mesh, edges, edge)));
    before = edge;
  }
  return turns;
}

/// Where the loop turns by at least 9/10 of its largest turn for the first time.
void start_at_corner(const Mesh& mesh, const Edges& edges, Chain& loop) {
  const std::vector<double> turns = turns_of(mesh, edges, loop);
  const double sharpest = *std::max_element(turns.begin(), turns.end());
  const auto is_corner = [&](double turn) { return turn >= 0.9 * sharpest; };
  const auto corner = std::find_if(turns.begin(), turns.end(), is_corner);
  std::rotate(loop.begin(), loop.begin() + (corner - turns.begin()),
              loop.end());
}

/// Takes the chain that begins at a vertex out of the edges that leave vertices.
Chain taken(const Edges& edges, int vertex, EdgeByVertex& leaving) {
  Chain chain;
  for (auto next = leaving.find(vertex); next != leaving.end();
       next = leaving.find(vertex)) {
    chain.push_back(next->second);
    vertex = edges.vertices(1, next->second);
    leaving.erase(next);
  }
  return chain;
}

std::set<int> second_vertices(const Edges& edges,
                              const std::vector<int>& boundary) {
  std::set<int> vertices;
  for (int e : boundary) vertices.insert(edges.vertices(1, e));
  return vertices;
}

/// The vertices that an edge leaves and none arrives at.
std::vector<int> starts(const Edges& edges, const std::vector<int>& boundary,
                        const EdgeByVertex& leaving) {
  const std::set<int> arrived = second_vertices(edges, boundary);
  std::vector<int> result;
  for (const auto& [vertex, edge] : leaving)
    if (!arrived.count(vertex)) result.push_back(vertex);
  return result;
}

}  // namespace

std::vector<int> labelled_boundary(const Mesh& mesh, const Edges& edges,
                                   const std::vector<int>& labels) {
  if (labels.empty()) refuse("no contact label is given");
  return labelled_facets(mesh, edges, labels);
}

std::vector<std::vector<int>> boundary_chains(
    const Mesh& mesh, const Edges& edges, const std::vector<int>& boundary) {
  EdgeByVertex leaving;
  for (int e : boundary) leaving[edges.vertices(0, e)] = e;
  std::vector<Chain> chains;
  for (int vertex : starts(edges, boundary, leaving))
    chains.push_back(taken(edges, vertex, leaving));
  while (!leaving.empty()) {
    chains.push_back(taken(edges, leaving.begin()->first, leaving));
    start_at_corner(mesh, edges, chains.back());
  }
  return chains;
}

}  // namespace ffcontact
