// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/edges.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

std::string refusal_of_edges(const Mesh& mesh) {
  return refusal([&] { edges_of(mesh); });
}

std::set<int> ends(const Edges& edges, int e) {
  return {edges.vertices(0, e), edges.vertices(1, e)};
}

/// A square of two triangles with one labelled edge more than its sides.
Mesh square_with_labelled_edge(int a, int b) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  mesh.boundary.conservativeResize(Eigen::NoChange, 5);
  mesh.boundary.col(4) << a, b;
  mesh.boundary_label.conservativeResize(5);
  mesh.boundary_label[4] = 7;
  return mesh;
}

RC_GTEST_PROP(Edges, vertices_less_edges_plus_triangles_are_one,
              (Random random)) {
  const Mesh mesh = irregular(4, 3, 4, 3, random);
  RC_ASSERT(mesh.vertex_count() - edges_of(mesh).count() + mesh.cell_count() ==
            1);
}

RC_GTEST_PROP(Edges, local_edge_k_is_opposite_to_local_vertex_k,
              (Random random)) {
  const Mesh mesh = irregular(4, 3, 4, 3, random);
  const Edges edges = edges_of(mesh);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::set<int> others{mesh.cells((k + 1) % 3, t),
                                 mesh.cells((k + 2) % 3, t)};
      RC_ASSERT(ends(edges, edges.of_cell(k, t)) == others);
    }
}

RC_GTEST_PROP(Edges, eta_is_one_on_the_left_and_minus_one_on_the_right,
              (Random random)) {
  const Mesh mesh = irregular(4, 3, 4, 3, random);
  const Edges edges = edges_of(mesh);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int e = edges.of_cell(k, t);
      RC_ASSERT(edges.eta(k, t) == (edges.cells(0, e) == t ? 1 : -1));
      RC_ASSERT(edges.cells(edges.eta(k, t) > 0 ? 0 : 1, e) == t);
      const Vector2d to_apex =
          mesh.corner(t, k) - mesh.vertices.col(edges.vertices(0, e));
      RC_ASSERT(edges.eta(k, t) * edge_normal(mesh, edges, e).dot(to_apex) < 0);
    }
}

RC_GTEST_PROP(Edges, boundary_runs_counter_clockwise_around_the_body,
              (Random random)) {
  const Mesh mesh = irregular(4, 3, 4, 3, random);
  const Edges edges = edges_of(mesh);
  double twice_area = 0;
  for (int e = 0; e < edges.count(); ++e) {
    if (!edges.on_boundary(e)) continue;
    const Vector2d a = mesh.vertices.col(edges.vertices(0, e)),
                   b = mesh.vertices.col(edges.vertices(1, e));
    twice_area += a.x() * b.y() - a.y() * b.x();
  }
  RC_ASSERT(std::abs(twice_area - 24) < 24e-14);
}

RC_GTEST_PROP(Edges, outward_normals_follow_the_labels, (Random random)) {
  const Mesh mesh = irregular(4, 3, 4, 3, random);
  const Edges edges = edges_of(mesh);
  const std::map<int, Vector2d> outward{
      {bottom, {0, -1}}, {right, {1, 0}}, {top, {0, 1}}, {left, {-1, 0}}};
  int on_boundary = 0;
  for (int e = 0; e < edges.count(); ++e) {
    RC_ASSERT(edges.on_boundary(e) == (edges.boundary_index[e] >= 0));
    if (!edges.on_boundary(e)) continue;
    ++on_boundary;
    const int b = edges.boundary_index[e];
    RC_ASSERT(ends(edges, e) ==
              (std::set<int>{mesh.boundary(0, b), mesh.boundary(1, b)}));
    RC_ASSERT((edge_normal(mesh, edges, e) - outward.at(mesh.boundary_label[b]))
                  .norm() < 1e-13);
  }
  RC_ASSERT(on_boundary == mesh.boundary.cols());
}

TEST(Edges, a_labelled_edge_inside_the_body_is_allowed) {
  const Edges edges = edges_of(square_with_labelled_edge(0, 3));
  const int diagonal = edges.of_cell(1, 0);
  EXPECT_FALSE(edges.on_boundary(diagonal));
  EXPECT_EQ(edges.boundary_index[diagonal], 4);
}

TEST(Edges, refuses_a_boundary_edge_without_label) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  mesh.boundary.conservativeResize(Eigen::NoChange, 3);
  mesh.boundary_label.conservativeResize(3);
  EXPECT_EQ(refusal_of_edges(mesh),
            "the boundary edge between vertices 0 and 2 has no label");
}

TEST(Edges, refuses_a_labelled_edge_of_no_triangle) {
  EXPECT_EQ(refusal_of_edges(square_with_labelled_edge(1, 2)),
            "labelled edge 4 belongs to no triangle");
}

TEST(Edges, refuses_triangles_that_overlap) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  mesh.cells.conservativeResize(Eigen::NoChange, 3);
  mesh.cells.col(2) = mesh.cells.col(0);
  EXPECT_EQ(refusal_of_edges(mesh),
            "the edge between vertices 0 and 1 has triangles that overlap");
}

TEST(Edges,
     refuses_two_triangles_on_the_right_of_an_edge_with_one_on_its_left) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  mesh.vertices.resize(2, 5);
  mesh.vertices << 0, 1, 0.5, 0.5, 0.6, 0, 0, 1, -1, -0.8;
  mesh.cells.resize(3, 3);
  mesh.cells << 1, 1, 0, 0, 0, 1, 3, 4, 2;
  EXPECT_EQ(refusal_of_edges(mesh),
            "the edge between vertices 0 and 1 has triangles that overlap");
}

TEST(Edges, refuses_a_third_triangle_on_an_edge) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  mesh.vertices.conservativeResize(Eigen::NoChange, 5);
  mesh.vertices.col(4) << 0.8, 0.1;
  mesh.cells.conservativeResize(Eigen::NoChange, 3);
  mesh.cells.col(2) << 0, 4, 3;
  EXPECT_EQ(refusal_of_edges(mesh),
            "the edge between vertices 0 and 3 has triangles that overlap");
}

}  // namespace
}  // namespace ffcontact
