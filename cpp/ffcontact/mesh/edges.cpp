// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/edges.hpp"

#include <algorithm>
#include <vector>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// One side of a triangle, or one labelled edge (triangle = -1), keyed by its sorted
/// vertices.
struct Side {
  int low, high;
  int triangle;
  int local;  ///< opposite local vertex, or the column of Mesh::boundary
  bool operator<(const Side& other) const {
    if (low != other.low) return low < other.low;
    if (high != other.high) return high < other.high;
    return triangle > other.triangle;  // labelled edges come last among equals
  }
  bool same_edge(const Side& other) const {
    return low == other.low && high == other.high;
  }
};

/// By their low vertices first, which is counting; few sides have the same.
std::vector<Side> sorted(const std::vector<Side>& sides, int vertices) {
  std::vector<std::size_t> start(vertices + 1, 0);
  for (const Side& side : sides) ++start[side.low + 1];
  for (int v = 0; v < vertices; ++v) start[v + 1] += start[v];
  std::vector<Side> result(sides.size());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (const Side& side : sides) result[next[side.low]++] = side;
  for (int v = 0; v < vertices; ++v)
    std::sort(result.begin() + start[v], result.begin() + start[v + 1]);
  return result;
}

std::vector<Side> sorted_sides(const Mesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.cells.cols() + mesh.boundary.cols());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] =
          std::minmax({mesh.cells((k + 1) % 3, t), mesh.cells((k + 2) % 3, t)});
      sides.push_back({low, high, t, k});
    }
  for (int e = 0; e < mesh.boundary.cols(); ++e) {
    const auto [low, high] = std::minmax({mesh.boundary(0, e), mesh.boundary(1, e)});
    sides.push_back({low, high, -1, e});
  }
  return sorted(sides, mesh.vertex_count());
}

}  // namespace

Edges edges_of(const Mesh& mesh) {
  const std::vector<Side> sides = sorted_sides(mesh);
  Edges edges;
  const Index most = 3 * mesh.cells.cols();
  edges.vertices.resize(2, most);
  edges.cells.resize(2, most);
  edges.boundary_index.resize(most);
  edges.of_cell.resize(3, mesh.cells.cols());
  edges.eta.resize(3, mesh.cells.cols());

  int count = 0;
  for (std::size_t s = 0; s < sides.size();) {
    const Side& first = sides[s];
    if (first.triangle < 0)
      refuse("labelled edge ", first.local, " belongs to no triangle");
    const int start = mesh.cells((first.local + 1) % 3, first.triangle);
    edges.vertices.col(count) << start, (start == first.low ? first.high : first.low);
    edges.cells.col(count) << first.triangle, -1;
    edges.boundary_index[count] = -1;
    for (; s < sides.size() && sides[s].same_edge(first); ++s) {
      const Side& side = sides[s];
      if (side.triangle < 0) {
        edges.boundary_index[count] = side.local;
        continue;
      }
      const bool left = mesh.cells((side.local + 1) % 3, side.triangle) == start;
      if (side.triangle != first.triangle) {
        if (left || edges.cells(1, count) >= 0)
          refuse("the edge between vertices ", side.low, " and ", side.high,
                 " has triangles that overlap");
        edges.cells(1, count) = side.triangle;
      }
      edges.of_cell(side.local, side.triangle) = count;
      edges.eta(side.local, side.triangle) = left ? 1.0 : -1.0;
    }
    if (edges.on_boundary(count) && edges.boundary_index[count] < 0)
      refuse("the boundary edge between vertices ", first.low, " and ", first.high,
             " has no label");
    ++count;
  }
  edges.vertices.conservativeResize(2, count);
  edges.cells.conservativeResize(2, count);
  edges.boundary_index.conservativeResize(count);
  return edges;
}

Vector2d edge_vector(const Mesh& mesh, const Edges& edges, int edge) {
  return mesh.vertices.col(edges.vertices(1, edge)) -
         mesh.vertices.col(edges.vertices(0, edge));
}

Vector2d edge_normal(const Mesh& mesh, const Edges& edges, int edge) {
  return turned_right(edge_vector(mesh, edges, edge).normalized());
}

}  // namespace ffcontact
