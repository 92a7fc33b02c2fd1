// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "ffcontact/mesh/mesh.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

std::string refusal_of(const SolidMesh& mesh) {
  return refusal([&] { require_valid(mesh); });
}

SolidMesh unit_tetrahedron() {
  SolidMesh mesh;
  mesh.vertices.resize(3, 4);
  mesh.vertices << Vector3d::Zero(), Matrix3d::Identity();
  mesh.cells.resize(4, 1);
  mesh.cells << 0, 1, 2, 3;
  add_boundary(mesh);
  return mesh;
}

TEST(SolidMesh, the_unit_tetrahedron_has_a_sixth_and_gradients_along_the_axes) {
  const SolidMesh mesh = unit_tetrahedron();
  EXPECT_DOUBLE_EQ(signed_volume(mesh, 0), 1. / 6);
  Matrix<double, 3, 4> expected;
  expected << -Vector3d::Ones(), Matrix3d::Identity();
  EXPECT_LT((hat_gradients(mesh, 0) - expected).norm(), 1e-15);
}

TEST(SolidMesh, the_vector_of_a_face_is_its_area_along_its_normal) {
  Matrix3d corners;
  corners << Vector3d(0, 0, 5), Vector3d(2, 0, 5), Vector3d(0, 3, 5);
  EXPECT_EQ(facet_vector(corners), Vector3d(0, 0, 3));
}

RC_GTEST_PROP(SolidMesh,
              outward_vectors_of_the_facets_of_a_cell_add_up_to_nothing,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < 4; ++k) {
      Matrix3d corners;
      for (int i = 0; i < 3; ++i)
        corners.col(i) = mesh.corner(t, facet_corners<3>[k][i]);
      const Vector3d outward = facet_vector(corners);
      RC_ASSERT(outward.dot(mesh.corner(t, k) - corners.col(0)) < 0);
      sum += outward;
    }
    RC_ASSERT(sum.norm() < 1e-14);
  }
}

TEST(SolidMesh, refuses_a_mesh_without_tetrahedra) {
  EXPECT_EQ(refusal_of(SolidMesh{}), "the mesh has no tetrahedra");
}

TEST(SolidMesh, refuses_a_tetrahedron_that_is_inverted_or_flat) {
  SolidMesh mesh = unit_tetrahedron();
  mesh.vertices(2, 3) = -0.75;
  EXPECT_EQ(refusal_of(mesh),
            "tetrahedron 0 has the volume -0.125, not positive");
  mesh.vertices(2, 3) = 0;
  EXPECT_EQ(refusal_of(mesh), "tetrahedron 0 has the volume 0, not positive");
}

TEST(SolidMesh, refuses_a_vertex_out_of_range) {
  SolidMesh mesh = unit_tetrahedron();
  mesh.cells(3, 0) = 4;
  EXPECT_EQ(refusal_of(mesh),
            "tetrahedron 0 names vertex 4 of a mesh with 4 vertices");
  mesh = unit_tetrahedron();
  mesh.boundary(2, 1) = -1;
  EXPECT_EQ(refusal_of(mesh),
            "boundary face 1 names vertex -1 of a mesh with 4 vertices");
}

TEST(SolidMesh, refuses_a_coordinate_that_is_not_finite) {
  SolidMesh mesh = unit_tetrahedron();
  mesh.vertices(2, 1) = std::nan("");
  EXPECT_EQ(refusal_of(mesh),
            "the mesh has a vertex whose coordinates are not finite");
}

TEST(SolidMesh, refuses_boundary_faces_without_label) {
  SolidMesh mesh = unit_tetrahedron();
  mesh.boundary_label.conservativeResize(3);
  EXPECT_EQ(refusal_of(mesh), "boundary_label has 3 values where 4 are needed");
}

}  // namespace
}  // namespace ffcontact
