// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/crossings.hpp"

#include <algorithm>
#include <vector>

namespace ffcontact {

namespace {

/// Unit vectors along the sides of some triangles that begin at a vertex.
std::vector<Vector2d> directions(const Mesh& mesh,
                                 const std::vector<int>& cells, int vertex) {
  std::vector<Vector2d> directions;
  for (const int t : cells)
    for (const int w : mesh.cells.col(t))
      if (w != vertex)
        directions.emplace_back(
            (mesh.vertices.col(w) - mesh.vertices.col(vertex)).normalized());
  return directions;
}

/// Has a direction its opposite?
bool goes_on(const Vector2d& a, const std::vector<Vector2d>& directions) {
  constexpr double straight = 1e-6;
  return std::any_of(
      directions.begin(), directions.end(),
      [&](const Vector2d& b) { return (a + b).norm() < straight; });
}

bool are_lines(const std::vector<Vector2d>& directions) {
  return std::all_of(directions.begin(), directions.end(),
                     [&](const Vector2d& a) { return goes_on(a, directions); });
}

}  // namespace

double crossing_share(const Mesh& mesh) {
  std::vector<std::vector<int>> cells(mesh.vertex_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (const int v : mesh.cells.col(t)) cells[v].push_back(t);
  int crossings = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    crossings +=
        cells[v].size() == 4 && are_lines(directions(mesh, cells[v], v));
  return static_cast<double>(crossings) / mesh.cell_count();
}

}  // namespace ffcontact
