// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/stars.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.hpp"
#include "support/pi.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Vector along spoke k of a vertex, away from it.
Vector2d spoke_vector(const Topology& body, int vertex, int k) {
  const int e = body.stars.spoke[body.stars.spoke_start[vertex] + k];
  const double away = body.edges.vertices(0, e) == vertex ? 1 : -1;
  return away * edge_vector(body.mesh, body.edges, e);
}

/// Angle from spoke k to the next one, in (-pi, pi].
double angle(const Topology& body, int vertex, int k) {
  const Vector2d a = spoke_vector(body, vertex, k);
  const Vector2d b =
      spoke_vector(body, vertex, (k + 1) % body.stars.spoke_count(vertex));
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

/// Interior angle of the rectangle (0, width) x (0, height) at a point.
double angle_of_rectangle(const Vector2d& x, double width, double height) {
  const bool on_vertical = x.x() == 0 || x.x() == width,
             on_horizontal = x.y() == 0 || x.y() == height;
  return 2 * pi / ((on_vertical ? 2 : 1) * (on_horizontal ? 2 : 1));
}

RC_GTEST_PROP(Stars, angles_are_positive_and_sum_to_the_angle_of_the_body,
              (Random random)) {
  const Topology body = topology_of(irregular(4, 3, 8, 6, random));
  for (int v = 0; v < body.mesh.vertex_count(); ++v) {
    double sum = 0;
    for (int k = 0; k < body.stars.triangle_count(v); ++k) {
      RC_ASSERT(angle(body, v, k) > 0);
      sum += angle(body, v, k);
    }
    RC_ASSERT(std::abs(sum - angle_of_rectangle(body.mesh.vertices.col(v), 8,
                                                6)) < 1e-12);
  }
}

RC_GTEST_PROP(Stars, triangle_k_lies_between_spokes_k_and_k_plus_one,
              (Random random)) {
  const Topology body = topology_of(irregular(4, 3, 4, 3, random));
  const Stars& stars = body.stars;
  for (int v = 0; v < body.mesh.vertex_count(); ++v)
    for (int k = 0; k < stars.triangle_count(v); ++k) {
      const int t = stars.triangle[stars.triangle_start[v] + k],
                local = stars.local[stars.triangle_start[v] + k];
      const int* spokes = stars.spoke.data() + stars.spoke_start[v];
      RC_ASSERT(body.mesh.cells(local, t) == v);
      RC_ASSERT(body.edges.of_cell((local + 2) % 3, t) == spokes[k]);
      RC_ASSERT(body.edges.of_cell((local + 1) % 3, t) ==
                spokes[(k + 1) % stars.spoke_count(v)]);
    }
}

RC_GTEST_PROP(Stars, a_boundary_star_begins_and_ends_at_boundary_edges,
              (Random random)) {
  const Topology body = topology_of(irregular(4, 3, 4, 3, random));
  const Stars& stars = body.stars;
  for (int v = 0; v < body.mesh.vertex_count(); ++v) {
    const int first = stars.spoke[stars.spoke_start[v]],
              last = stars.spoke[stars.spoke_start[v + 1] - 1];
    RC_ASSERT(body.edges.on_boundary(first) == stars.on_boundary(v));
    RC_ASSERT(body.edges.on_boundary(last) == stars.on_boundary(v));
    RC_ASSERT(stars.spoke_count(v) ==
              stars.triangle_count(v) + (stars.on_boundary(v) ? 1 : 0));
  }
}

TEST(Stars, a_vertex_without_triangles_has_an_empty_star) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  mesh.vertices.conservativeResize(Eigen::NoChange, 5);
  mesh.vertices.col(4) << 9, 9;
  const Stars stars = stars_of(mesh, edges_of(mesh));
  EXPECT_EQ(stars.triangle_count(4), 0);
  EXPECT_EQ(stars.spoke_count(4), 0);
}

TEST(Stars, refuses_a_body_that_touches_itself_in_a_vertex) {
  Mesh mesh = joined(rectangle(1, 1, 1, 1), rectangle(1, 1, 1, 1));
  mesh.vertices.rightCols(4).array() += 1;
  const auto glue = [](int& v) {
    v = v == 4 ? 3 : v;
  };  // lower left corner of the second onto upper right of the first
  for (int& v : mesh.cells.reshaped()) glue(v);
  for (int& v : mesh.boundary.reshaped()) glue(v);
  const Edges edges = edges_of(mesh);
  EXPECT_EQ(refusal([&] { stars_of(mesh, edges); }),
            "the body touches itself in the single vertex 3");
}

}  // namespace
}  // namespace ffcontact
