// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/crossings.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace ffcontact {

namespace {

std::vector<std::vector<int>> cells_at_vertices(const Mesh& mesh) {
  std::vector<std::vector<int>> cells(mesh.vertex_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (const int v : mesh.cells.col(t)) cells[v].push_back(t);
  return cells;
}

/// The vertices that share triangles with one, once each.
std::set<int> neighbours(const Mesh& mesh, const std::vector<int>& cells,
                         int vertex) {
  std::set<int> neighbours;
  for (const int t : cells)
    for (const int w : mesh.cells.col(t))
      if (w != vertex) neighbours.insert(w);
  return neighbours;
}

std::vector<Vector2d> directions(const Mesh& mesh,
                                 const std::set<int>& neighbours, int vertex) {
  std::vector<Vector2d> directions;
  for (const int w : neighbours)
    directions.emplace_back(
        (mesh.vertices.col(w) - mesh.vertices.col(vertex)).normalized());
  return directions;
}

/// On the boundary a vertex has one neighbour more than triangles.
bool is_inside(const std::set<int>& neighbours, const std::vector<int>& cells) {
  return !cells.empty() && neighbours.size() == cells.size();
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

double crossing_share(const Mesh& mesh, int first, int end) {
  const auto cells = cells_at_vertices(mesh);
  double inside = 0, crossings = 0;
  for (int v = first; v < end; ++v) {
    const std::set<int> around = neighbours(mesh, cells[v], v);
    if (!is_inside(around, cells[v])) continue;
    ++inside;
    crossings += around.size() == 4 && are_lines(directions(mesh, around, v));
  }
  return inside > 0 ? crossings / inside : 0;
}

}  // namespace ffcontact
