// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/stars.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// The triangle on the other side of an edge, or -1.
int neighbour(const Edges& edges, int edge, int triangle) {
  return edges.cells(0, edge) == triangle ? edges.cells(1, edge)
                                          : edges.cells(0, edge);
}

int local_number(const Mesh& mesh, int triangle, int vertex) {
  for (int k = 0; k < 2; ++k)
    if (mesh.cells(k, triangle) == vertex) return k;
  return 2;
}

/// Seen from local vertex k, the edge on the right side of a triangle is opposite to k +
/// 2, the one on the left to k + 1.
int right_spoke(const Edges& edges, int triangle, int k) {
  return edges.of_cell((k + 2) % 3, triangle);
}
int left_spoke(const Edges& edges, int triangle, int k) {
  return edges.of_cell((k + 1) % 3, triangle);
}

/// Turns clockwise around a vertex to the triangle behind a boundary edge; an inner star
/// comes back to where it started.
int first_triangle(const Mesh& mesh, const Edges& edges, int vertex,
                   int start) {
  int triangle = start;
  for (;;) {
    const int k = local_number(mesh, triangle, vertex);
    const int spoke = right_spoke(edges, triangle, k);
    const int next = neighbour(edges, spoke, triangle);
    if (next < 0 || next == start) return next < 0 ? triangle : start;
    triangle = next;
  }
}

/// How many triangles a vertex has, and the last one of them, or -1.
struct Triangles {
  std::vector<int> count, any;
};

Triangles triangles_of(const Mesh& mesh) {
  const int n = mesh.vertex_count();
  Triangles triangles{std::vector<int>(n, 0), std::vector<int>(n, -1)};
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (const int v : mesh.cells.col(t)) {
      ++triangles.count[v];
      triangles.any[v] = t;
    }
  return triangles;
}

/// Appends what lies around a vertex, turning counter-clockwise from a triangle on.
void append_star(const Mesh& mesh, const Edges& edges, int vertex, int first,
                 Stars& stars) {
  for (int triangle = first; triangle >= 0;) {
    const int k = local_number(mesh, triangle, vertex);
    const int last = left_spoke(edges, triangle, k);
    stars.triangle.push_back(triangle);
    stars.local.push_back(k);
    stars.spoke.push_back(right_spoke(edges, triangle, k));
    triangle = neighbour(edges, last, triangle);
    if (triangle < 0) stars.spoke.push_back(last);
    if (triangle == first) break;
  }
}

void end_star(Stars& stars) {
  stars.triangle_start.push_back(count_of(stars.triangle));
  stars.spoke_start.push_back(count_of(stars.spoke));
}

}  // namespace

Stars stars_of(const Mesh& mesh, const Edges& edges) {
  const Triangles triangles = triangles_of(mesh);
  Stars stars;
  stars.triangle_start.assign(1, 0);
  stars.spoke_start.assign(1, 0);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const int any = triangles.any[v];
    if (any >= 0)
      append_star(mesh, edges, v, first_triangle(mesh, edges, v, any), stars);
    end_star(stars);
    if (stars.triangle_count(v) != triangles.count[v])
      refuse("the body touches itself in the single vertex ", v);
  }
  return stars;
}

}  // namespace ffcontact
