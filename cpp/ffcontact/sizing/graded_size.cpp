// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/graded_size.hpp"

#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace ffcontact {

namespace {

/// Vertices that an edge joins with each vertex, and its length.
using Neighbours = std::vector<std::vector<std::pair<int, double>>>;

template <int dim>
Neighbours neighbours_of(const SimplexMesh<dim>& mesh,
                         const Ref<const Matrix2Xi>& edges) {
  Neighbours neighbours(mesh.vertices.cols());
  for (Index e = 0; e < edges.cols(); ++e) {
    const int i = edges(0, e), j = edges(1, e);
    const double length = (mesh.vertices.col(j) - mesh.vertices.col(i)).norm();
    neighbours[i].emplace_back(j, length);
    neighbours[j].emplace_back(i, length);
  }
  return neighbours;
}

}  // namespace

template <int dim>
VectorXd graded_size(const SimplexMesh<dim>& mesh,
                     const Ref<const Matrix2Xi>& edges, VectorXd size,
                     double gradation) {
  const Neighbours neighbours = neighbours_of(mesh, edges);
  // Dijkstra's algorithm: the smallest size is final and bounds its neighbours.
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (Index v = 0; v < size.size(); ++v)
    queue.emplace(size[v], static_cast<int>(v));
  while (!queue.empty()) {
    const auto [h, v] = queue.top();
    queue.pop();
    if (h > size[v]) continue;
    for (const auto& [w, length] : neighbours[v]) {
      const double most = h + gradation * length;
      if (size[w] <= most) continue;
      size[w] = most;
      queue.emplace(most, w);
    }
  }
  return size;
}

template VectorXd graded_size(const SimplexMesh<FFCONTACT_DIMENSION>&,
                              const Ref<const Matrix2Xi>&, VectorXd, double);

}  // namespace ffcontact
