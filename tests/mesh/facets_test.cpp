// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/facets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

std::string refusal_of_facets(const SolidMesh& mesh) {
  return refusal([&] { facets_of(mesh); });
}

/// Two tetrahedra on both sides of the face 0, 1, 2.
SolidMesh bipyramid() {
  SolidMesh mesh;
  mesh.vertices.resize(3, 5);
  mesh.vertices << 0, 1, 0, 0, 0,  //
      0, 0, 1, 0, 0,               //
      0, 0, 0, 1, -1;
  mesh.cells.resize(4, 2);
  mesh.cells << 0, 0, 1, 2, 2, 1, 3, 4;
  add_boundary(mesh);
  return mesh;
}

void append_cell(SolidMesh& mesh, const Vector4i& cell) {
  mesh.cells.conservativeResize(Eigen::NoChange, mesh.cell_count() + 1);
  mesh.cells.col(mesh.cell_count() - 1) = cell;
}

void append_boundary(SolidMesh& mesh, const Vector3i& face) {
  const Index last = mesh.boundary.cols();
  mesh.boundary.conservativeResize(Eigen::NoChange, last + 1);
  mesh.boundary.col(last) = face;
  mesh.boundary_label.conservativeResize(last + 1);
  mesh.boundary_label[last] = 7;
}

std::set<int> corners(const Facets<3>& faces, int f) {
  return {faces.vertices(0, f), faces.vertices(1, f), faces.vertices(2, f)};
}

RC_GTEST_PROP(Faces, are_as_many_as_cells_and_boundary_ask_for,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Facets<3> faces = facets_of(mesh);
  int on_boundary = 0;
  for (int f = 0; f < faces.count(); ++f) on_boundary += faces.on_boundary(f);
  RC_ASSERT(on_boundary == mesh.boundary.cols());
  RC_ASSERT(2 * faces.count() == 4 * mesh.cell_count() + on_boundary);
}

RC_GTEST_PROP(Faces, local_face_k_is_opposite_to_local_vertex_k,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Facets<3> faces = facets_of(mesh);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 4; ++k) {
      const std::set<int> others{mesh.cells((k + 1) % 4, t),
                                 mesh.cells((k + 2) % 4, t),
                                 mesh.cells((k + 3) % 4, t)};
      RC_ASSERT(corners(faces, faces.of_cell(k, t)) == others);
    }
}

RC_GTEST_PROP(Faces, normals_point_out_of_the_first_cell_and_into_the_second,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Facets<3> faces = facets_of(mesh);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 4; ++k) {
      const int f = faces.of_cell(k, t);
      RC_ASSERT(std::abs(faces.eta(k, t)) == 1);
      RC_ASSERT(faces.cells(faces.eta(k, t) > 0 ? 0 : 1, f) == t);
      const Vector3d to_apex =
          mesh.corner(t, k) - mesh.vertices.col(faces.vertices(0, f));
      RC_ASSERT(faces.eta(k, t) * facet_normal(mesh, faces, f).dot(to_apex) <
                0);
    }
}

RC_GTEST_PROP(Faces, areas_and_normals_of_each_cell_obey_the_divergence_theorem,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Facets<3> faces = facets_of(mesh);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    Vector3d closed = Vector3d::Zero();
    double flux = 0;  // of the position
    for (int k = 0; k < 4; ++k) {
      const int f = faces.of_cell(k, t);
      const Vector3d outward = faces.eta(k, t) * facet_measure(mesh, faces, f) *
                               facet_normal(mesh, faces, f);
      closed += outward;
      flux += outward.dot(mesh.vertices.col(faces.vertices(1, f)));
    }
    RC_ASSERT(closed.norm() < 1e-14);
    RC_ASSERT(std::abs(flux - 3 * signed_volume(mesh, t)) < 1e-13);
  }
}

RC_GTEST_PROP(Faces, outward_normals_and_areas_follow_the_labels,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Facets<3> faces = facets_of(mesh);
  Matrix<double, 6, 1> area = Matrix<double, 6, 1>::Zero();
  for (int f = 0; f < faces.count(); ++f) {
    RC_ASSERT(faces.on_boundary(f) == (faces.boundary_index[f] >= 0));
    if (!faces.on_boundary(f)) continue;
    const int b = faces.boundary_index[f], label = mesh.boundary_label[b];
    RC_ASSERT(corners(faces, f) ==
              (std::set<int>{mesh.boundary(0, b), mesh.boundary(1, b),
                             mesh.boundary(2, b)}));
    const Vector3d outward = Vector3d::Unit((label - low_x) / 2) *
                             ((label - low_x) % 2 == 0 ? -1 : 1);
    RC_ASSERT((facet_normal(mesh, faces, f) - outward).norm() < 1e-14);
    area[label - low_x] += facet_measure(mesh, faces, f);
  }
  Matrix<double, 6, 1> expected;
  expected << 4, 4, 6, 6, 6, 6;
  RC_ASSERT((area - expected).norm() < 1e-13);
}

TEST(Faces, of_a_bipyramid_are_seven_in_the_order_of_their_vertices) {
  const Facets<3> faces = facets_of(bipyramid());
  ASSERT_EQ(faces.count(), 7);
  EXPECT_EQ(corners(faces, 0), (std::set<int>{0, 1, 2}));
  EXPECT_EQ(corners(faces, 1), (std::set<int>{0, 1, 3}));
  EXPECT_EQ(corners(faces, 6), (std::set<int>{1, 2, 4}));
  EXPECT_EQ(faces.cells.col(0).sum(), 1);
}

TEST(Faces, a_labelled_face_inside_the_body_is_allowed) {
  SolidMesh mesh = bipyramid();
  append_boundary(mesh, {2, 0, 1});
  const Facets<3> faces = facets_of(mesh);
  EXPECT_FALSE(faces.on_boundary(0));
  EXPECT_EQ(faces.boundary_index[0], 6);
}

TEST(Faces, refuses_a_boundary_face_without_label) {
  SolidMesh mesh = bipyramid();
  mesh.boundary.conservativeResize(Eigen::NoChange, 5);
  mesh.boundary_label.conservativeResize(5);
  EXPECT_EQ(refusal_of_facets(mesh),
            "the boundary face between vertices 1, 2 and 4 has no label");
}

TEST(Faces, refuses_a_labelled_face_of_no_tetrahedron) {
  SolidMesh mesh = bipyramid();
  append_boundary(mesh, {0, 3, 4});
  EXPECT_EQ(refusal_of_facets(mesh),
            "labelled face 6 belongs to no tetrahedron");
}

TEST(Faces, refuses_tetrahedra_that_overlap) {
  SolidMesh mesh = bipyramid();
  append_cell(mesh, {0, 1, 2, 3});
  EXPECT_EQ(refusal_of_facets(mesh),
            "the face between vertices 0, 1 and 2 has tetrahedra that overlap");
  mesh = bipyramid();
  mesh.vertices(2, 4) = 2;
  mesh.cells.col(1) << 0, 1, 2, 4;
  EXPECT_EQ(refusal_of_facets(mesh),
            "the face between vertices 0, 1 and 2 has tetrahedra that overlap");
}

}  // namespace
}  // namespace ffcontact
