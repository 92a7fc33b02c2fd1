// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/edges.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

std::string refusal_of_edges(const Mesh& mesh) {
  return refusal([&] { edges_of(mesh); });
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
