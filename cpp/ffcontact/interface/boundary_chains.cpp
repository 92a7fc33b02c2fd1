// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/boundary_chains.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "ffcontact/base/over.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/labelled_facets.hpp"
#include "ffcontact/mesh/turns.hpp"

namespace ffcontact {

namespace {

using Chain = std::vector<int>;

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

/// Edges while they are taken into chains.
class Leaving {
 public:
  Leaving(const Edges& edges, const std::vector<int>& boundary)
      : edges_(edges) {
    for (int e : boundary) {
      leaving_.emplace(edges.vertices(0, e), e);
      ++arriving_[edges.vertices(1, e)];
    }
    for (const auto& [vertex, edge] : leaving_)
      if (leaving_.count(vertex) != 1 || arriving_[vertex] != 1)
        starts_.insert(vertex);
  }

  std::vector<Chain> chains() {
    std::vector<Chain> chains;
    for (int vertex : starts_)
      while (leaving_.count(vertex) > 0) chains.push_back(taken(vertex));
    return chains;
  }
  std::vector<Chain> loops() {
    std::vector<Chain> loops;
    while (!leaving_.empty()) loops.push_back(taken(leaving_.begin()->first));
    return loops;
  }

 private:
  /// The chain from a vertex to where the next one starts, or around.
  Chain taken(int vertex) {
    Chain chain;
    auto next = leaving_.find(vertex);
    do {
      chain.push_back(next->second);
      vertex = edges_.vertices(1, next->second);
      leaving_.erase(next);
      next = leaving_.find(vertex);
    } while (next != leaving_.end() && !starts_.count(vertex));
    return chain;
  }

  const Edges& edges_;
  std::multimap<int, int> leaving_;  ///< by first vertex
  std::map<int, int> arriving_;      ///< their number, by second vertex
  std::set<int> starts_;             ///< vertices
};

}  // namespace

std::vector<int> labelled_boundary(const Mesh& mesh, const Edges& edges,
                                   const std::vector<int>& labels) {
  if (labels.empty()) refuse("no contact label is given");
  return labelled_facets(mesh, edges, labels);
}

std::vector<int> boundary_edges(const Edges& edges) {
  return numbers_where(edges.count(),
                       [&](int e) { return edges.on_boundary(e); });
}

std::vector<std::vector<int>> boundary_chains(
    const Mesh& mesh, const Edges& edges, const std::vector<int>& boundary) {
  Leaving leaving(edges, boundary);
  std::vector<Chain> chains = leaving.chains();
  for (Chain& loop : leaving.loops()) {
    start_at_corner(mesh, edges, loop);
    chains.push_back(std::move(loop));
  }
  return chains;
}

Matrix2Xd points_of(const Mesh& mesh, const Edges& edges,
                    const std::vector<int>& chain) {
  std::vector<int> vertices{edges.vertices(0, chain.front())};
  for (int edge : chain) vertices.push_back(edges.vertices(1, edge));
  return mesh.vertices(Eigen::all, vertices);
}

Matrix2Xd places_of(const Mesh& mesh, const Edges& edges,
                    const std::vector<int>& boundary) {
  const Matrix2Xi vertices = edges.vertices(Eigen::all, boundary);
  return mesh.vertices(Eigen::all, vertices.reshaped()).colwise() + mesh.origin;
}

}  // namespace ffcontact
