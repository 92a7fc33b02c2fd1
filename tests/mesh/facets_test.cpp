// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/facets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "support/irregular_bodies.hpp"
#include "support/refusals.hpp"

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

template <int d>
std::set<int> corners(const Facets<d>& facets, int f) {
  const auto vertices = facets.vertices.col(f);
  return {vertices.begin(), vertices.end()};
}

template <int d>
void are_as_many_as_cells_and_boundary_ask_for(Random& random) {
  const SimplexMesh<d> mesh = irregular_body<d>(random);
  const Facets<d> facets = facets_of(mesh);
  int on_boundary = 0;
  for (int f = 0; f < facets.count(); ++f) on_boundary += facets.on_boundary(f);
  RC_ASSERT(on_boundary == mesh.boundary.cols());
  RC_ASSERT(2 * facets.count() == (d + 1) * mesh.cell_count() + on_boundary);
  if (d == 2)
    RC_ASSERT(mesh.vertex_count() - facets.count() + mesh.cell_count() == 1);
}

PROPERTY_IN_BOTH_DIMENSIONS(Facets, are_as_many_as_cells_and_boundary_ask_for)

template <int d>
void local_facet_k_is_opposite_to_local_vertex_k(Random& random) {
  const SimplexMesh<d> mesh = irregular_body<d>(random);
  const Facets<d> facets = facets_of(mesh);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k <= d; ++k) {
      std::set<int> others;
      for (int turn = 1; turn <= d; ++turn)
        others.insert(mesh.cells((k + turn) % (d + 1), t));
      RC_ASSERT(corners(facets, facets.of_cell(k, t)) == others);
    }
}

PROPERTY_IN_BOTH_DIMENSIONS(Facets, local_facet_k_is_opposite_to_local_vertex_k)

template <int d>
void normals_point_out_of_the_first_cell_and_into_the_second(Random& random) {
  const SimplexMesh<d> mesh = irregular_body<d>(random);
  const Facets<d> facets = facets_of(mesh);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k <= d; ++k) {
      const int f = facets.of_cell(k, t);
      RC_ASSERT(std::abs(facets.eta(k, t)) == 1);
      RC_ASSERT(facets.cells(facets.eta(k, t) > 0 ? 0 : 1, f) == t);
      const VectorOf<d> to_apex =
          mesh.corner(t, k) - mesh.vertices.col(facets.vertices(0, f));
      RC_ASSERT(facets.eta(k, t) * facet_normal(mesh, facets, f).dot(to_apex) <
                0);
    }
}

PROPERTY_IN_BOTH_DIMENSIONS(
    Facets, normals_point_out_of_the_first_cell_and_into_the_second)

template <int d>
void measures_and_normals_obey_the_divergence_theorem(Random& random) {
  const SimplexMesh<d> mesh = irregular_body<d>(random);
  const Facets<d> facets = facets_of(mesh);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    VectorOf<d> closed = VectorOf<d>::Zero();
    double flux = 0;  // of the position
    for (int k = 0; k <= d; ++k) {
      const int f = facets.of_cell(k, t);
      const VectorOf<d> outward = facets.eta(k, t) *
                                  facet_measure(mesh, facets, f) *
                                  facet_normal(mesh, facets, f);
      closed += outward;
      flux += outward.dot(mesh.vertices.col(facets.vertices(1, f)));
    }
    RC_ASSERT(closed.norm() < 1e-14);
    RC_ASSERT(std::abs(flux - d * signed_volume(mesh, t)) < 1e-13);
  }
}

PROPERTY_IN_BOTH_DIMENSIONS(Facets,
                            measures_and_normals_obey_the_divergence_theorem)

/// On each side: outward normals, and measures that add up to that of the box's side.
template <int d>
void outward_normals_and_measures_follow_the_labels(Random& random) {
  const SimplexMesh<d> mesh = irregular_body<d>(random);
  const Facets<d> facets = facets_of(mesh);
  VectorXd measure = VectorXd::Zero(2 * d);
  double flux = 0;  // of the position
  for (int f = 0; f < facets.count(); ++f) {
    RC_ASSERT(facets.on_boundary(f) == (facets.boundary_index[f] >= 0));
    if (!facets.on_boundary(f)) continue;
    const int b = facets.boundary_index[f], label = mesh.boundary_label[b];
    const auto listed = mesh.boundary.col(b);
    RC_ASSERT(corners(facets, f) ==
              std::set<int>(listed.begin(), listed.end()));
    RC_ASSERT(
        (facet_normal(mesh, facets, f) - outward_of_side<d>(label)).norm() <
        1e-13);
    measure[label - 1] += facet_measure(mesh, facets, f);
    const MatrixOf<d> ends = mesh.vertices(Eigen::all, facets.vertices.col(f));
    flux += facet_vector(ends).dot(ends.col(0));
  }
  const VectorOf<d> sizes = body_sizes<d>();
  for (int side = 0; side < 2 * d; ++side) {
    const double across = outward_of_side<d>(side + 1).cwiseAbs().dot(sizes);
    RC_ASSERT(std::abs(measure[side] - sizes.prod() / across) < 1e-13);
  }
  RC_ASSERT(std::abs(flux / d - sizes.prod()) < 1e-14 * sizes.prod());
}

PROPERTY_IN_BOTH_DIMENSIONS(Facets,
                            outward_normals_and_measures_follow_the_labels)

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
