// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/irregular_bodies.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

std::string refusal_of(const Mesh& mesh) {
  return refusal([&] { require_valid(mesh); });
}

template <int d>
void volumes_of_irregular_cells_add_up_to_the_body(Random& random) {
  const SimplexMesh<d> mesh = irregular_body<d>(random);
  require_valid(mesh);
  const double whole = body_sizes<d>().prod();
  double volume = 0;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    RC_ASSERT(signed_volume(mesh, t) > 0);
    volume += signed_volume(mesh, t);
  }
  RC_ASSERT(std::abs(volume - whole) < 1e-14 * whole);
}

PROPERTY_IN_BOTH_DIMENSIONS(Mesh, volumes_of_irregular_cells_add_up_to_the_body)

template <int d>
void hat_functions_add_up_to_one_and_reproduce_linear_functions(
    Random& random) {
  const SimplexMesh<d> mesh = irregular_body<d>(random);
  const VectorOf<d> slope = random_vector(d, random);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const Matrix<double, d, d + 1> gradients = hat_gradients(mesh, t);
    VectorOf<d + 1> values;
    for (int k = 0; k <= d; ++k) values[k] = 1 + slope.dot(mesh.corner(t, k));
    RC_ASSERT(gradients.rowwise().sum().norm() < 1e-12 * gradients.norm());
    RC_ASSERT((gradients * values - slope).norm() < 1e-11);
  }
}

PROPERTY_IN_BOTH_DIMENSIONS(
    Mesh, hat_functions_add_up_to_one_and_reproduce_linear_functions)

TEST(Mesh, accepts_a_rectangle) {
  EXPECT_EQ(refusal_of(rectangle(3, 2, 3, 2)), "accepted");
}

TEST(Mesh, of_a_rectangle_has_its_sides) {
  const Mesh mesh = rectangle(3, 2, 6, 4);
  const Vector2d middle[] = {{3, 0}, {6, 2}, {3, 4}, {0, 2}};
  for (int side = 0; side < 4; ++side) {
    Vector2d sum(0, 0);
    int count = 0;
    for (Index e = 0; e < mesh.boundary.cols(); ++e)
      if (mesh.boundary_label[e] == 1 + side) {
        sum += mesh.vertices(Eigen::all, mesh.boundary.col(e)).rowwise().mean();
        ++count;
      }
    EXPECT_EQ(count, side % 2 == 0 ? 3 : 2);
    EXPECT_LT((sum / count - middle[side]).norm(), 1e-14);
  }
}

TEST(Mesh, refuses_a_rectangle_without_extent) {
  const auto said = [](const Vector2i& cells, const Vector2d& size) {
    return refusal([&] { ffcontact::rectangle(cells, size); });
  };
  EXPECT_EQ(said({3, 0}, {1, 1}),
            "a rectangle has at least one cell each way, got 3 x 0");
  EXPECT_EQ(said({1, 1}, {1, -2}),
            "the sides of a rectangle are positive, got 1 and -2");
  EXPECT_TRUE(says(said({1, 1}, {INFINITY, 1}), "positive, got inf"));
}

TEST(Mesh, refuses_a_mesh_without_triangles) {
  EXPECT_EQ(refusal_of(Mesh{}), "the mesh has no triangles");
}

TEST(Mesh, refuses_a_facet_that_is_labelled_twice) {
  Mesh mesh = rectangle(2, 1, 2, 1);
  mesh.origin << 10, 20;
  mesh.boundary.conservativeResize(Eigen::NoChange, 7);
  mesh.boundary.col(6) = mesh.boundary.col(0).reverse();
  mesh.boundary_label.conservativeResize(7);
  mesh.boundary_label[6] = 7;
  EXPECT_EQ(refusal_of(mesh),
            "the edge at (10.5, 20) has two labels, 1 and 7: give it one of "
            "them (in gmsh, put it into one physical group)");
  mesh.boundary_label[6] = 1;
  EXPECT_EQ(refusal_of(mesh),
            "the edge at (10.5, 20) has the label 1 twice, and integrals over "
            "it count it twice: list it once");
}

TEST(Mesh, says_where_a_facet_inside_is_labelled_twice) {
  Mesh mesh = rectangle(2, 1, 2, 1);
  mesh.boundary.conservativeResize(Eigen::NoChange, 8);
  mesh.boundary.rightCols(2) << 1, 4, 4, 1;
  mesh.boundary_label.conservativeResize(8);
  mesh.boundary_label.tail(2) << 2, 3;
  EXPECT_TRUE(says(refusal_of(mesh),
                   "the edge at (1, 0.5) inside the body has two labels, 2 and "
                   "3: if bodies touch there"));
}

TEST(Mesh, refuses_a_coordinate_that_is_not_finite) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  mesh.vertices(1, 2) = std::nan("");
  EXPECT_EQ(refusal_of(mesh),
            "the mesh has a vertex whose coordinates are not finite");
}

TEST(Mesh, refuses_a_coordinate_whose_square_overflows) {
  Mesh mesh = rectangle(2, 2, 1, 1);
  mesh.vertices *= 1e70;
  require_valid(mesh);
  mesh.vertices *= 1e10;
  EXPECT_THROW(require_valid(mesh), std::invalid_argument);
}

TEST(Mesh, refuses_a_triangle_that_turns_clockwise) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  std::swap(mesh.cells(0, 1), mesh.cells(1, 1));
  EXPECT_EQ(refusal_of(mesh), "triangle 1 has the area -0.5, not positive");
}

TEST(Mesh, refuses_a_vertex_out_of_range) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  mesh.cells(2, 0) = 4;
  EXPECT_EQ(refusal_of(mesh),
            "triangle 0 names vertex 4 of a mesh with 4 vertices");
  mesh = rectangle(1, 1, 1, 1);
  mesh.boundary(0, 3) = -1;
  EXPECT_EQ(refusal_of(mesh),
            "boundary edge 3 names vertex -1 of a mesh with 4 vertices");
}

TEST(Mesh, refuses_boundary_edges_without_label) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  mesh.boundary_label.conservativeResize(3);
  EXPECT_EQ(refusal_of(mesh), "boundary_label has 3 values where 4 are needed");
}

}  // namespace
}  // namespace ffcontact
