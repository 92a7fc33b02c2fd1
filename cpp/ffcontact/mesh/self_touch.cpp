// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/self_touch.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "ffcontact/mesh/straight_runs.hpp"

namespace ffcontact {

namespace {

/// Vertices of labelled edges by their abscissae along a direction that hardly any edge
/// is normal to.
using ByAbscissa = std::vector<std::pair<double, int>>;

double oblique_abscissa(const Vector2d& x) {
  const Vector2d direction(0.8090, 0.5878);
  return direction.dot(x);
}

ByAbscissa vertices_of_edges(const Mesh& mesh) {
  ByAbscissa vertices;
  for (const int v : mesh.boundary.reshaped())
    vertices.emplace_back(oblique_abscissa(mesh.vertices.col(v)), v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

double distance(const Vector2d& x, const Matrix2d& edge) {
  const Vector2d along = edge.col(1) - edge.col(0), from = x - edge.col(0);
  const double place = from.dot(along) / along.squaredNorm();
  return (from - std::clamp(place, 0.0, 1.0) * along).norm();
}

/// A vertex that touches an edge without being an end of it.
std::optional<int> touching(const Mesh& mesh, Index column,
                            const ByAbscissa& vertices, double tolerance) {
  const Vector2i ends = mesh.boundary.col(column);
  const Matrix2d edge = facet_points<2>(mesh, ends);
  const auto [low, high] = std::minmax(
      {oblique_abscissa(edge.col(0)), oblique_abscissa(edge.col(1))});
  const auto first = std::lower_bound(vertices.begin(), vertices.end(),
                                      std::pair(low - tolerance, 0));
  for (auto at = first; at != vertices.end() && at->first <= high + tolerance;
       ++at) {
    const int v = at->second;
    if (v != ends[0] && v != ends[1] &&
        distance(mesh.vertices.col(v), edge) < tolerance)
      return v;
  }
  return std::nullopt;
}

}  // namespace

std::optional<int> self_touch(const Mesh& mesh) {
  const double tolerance = 4e-9 * extent(mesh.vertices);
  const ByAbscissa vertices = vertices_of_edges(mesh);
  for (Index e = 0; e < mesh.boundary.cols(); ++e)
    if (const auto vertex = touching(mesh, e, vertices, tolerance))
      return vertex;
  return std::nullopt;
}

}  // namespace ffcontact
