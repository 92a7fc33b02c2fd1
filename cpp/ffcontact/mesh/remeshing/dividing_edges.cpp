// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/dividing_edges.hpp"

#include <algorithm>
#include <utility>

namespace ffcontact {

std::vector<DividingEdge> dividing_edges(const Facets<3>& faces,
                                         const DividingFaces& dividing) {
  std::vector<std::pair<std::array<int, 2>, int>> sides;
  for (int k = 0; k < dividing.count(); ++k) {
    const Vector3i v = faces.vertices.col(dividing.face[k]);
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(v[i], v[(i + 1) % 3]);
      sides.push_back({{low, high}, k});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<DividingEdge> edges;
  for (const auto& [vertices, face] : sides) {
    if (edges.empty() || edges.back().vertices != vertices)
      edges.push_back({vertices, {}});
    edges.back().faces.push_back(face);
  }
  return edges;
}

}  // namespace ffcontact
