// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/contact_surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/pi.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

ContactSurface surface_of(const SolidMesh& mesh, std::vector<int> labels) {
  return contact_surface(mesh, facets_of(mesh), labels);
}

RC_GTEST_PROP(ContactSurface, of_a_plane_has_one_normal_and_all_of_its_area,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const ContactSurface surface = surface_of(mesh, {low_z});
  RC_ASSERT(surface.node_count() ==
            static_cast<int>(vertices_on(mesh, low_z).size()));
  RC_ASSERT(std::abs(surface.area.sum() - 6) < 1e-12);
  for (int i = 0; i < surface.node_count(); ++i) {
    RC_ASSERT(surface.normal.col(i) == -Vector3d::UnitZ());
    RC_ASSERT(surface.frame(i).col(1) == Vector3d::UnitX());
    RC_ASSERT(surface.frame(i).col(2) == Vector3d::UnitY());
  }
}

TEST(ContactSurface, has_a_node_for_each_plane_at_an_edge_and_a_corner) {
  const SolidMesh mesh = brick({2, 2, 2}, {1, 1, 1});
  const ContactSurface surface = surface_of(mesh, {low_x, low_y, low_z});
  EXPECT_EQ(surface.node_count(), 27);
  int at_corner = 0;
  for (int i = 0; i < 27; ++i)
    if (surface.vertex[i] == 0) ++at_corner;
  EXPECT_EQ(at_corner, 3);
}

/// A brick bent round the y axis: its side low_z is a cylinder.
SolidMesh bent(int cells, double angle) {
  SolidMesh mesh = brick({cells, 3, 1}, {1, 1, 0.2});
  for (auto x : mesh.vertices.colwise()) {
    const double turn = angle * (x.x() - 0.5), radius = 1 + x.z();
    x = Vector3d(radius * std::sin(turn), x.y(), radius * std::cos(turn));
  }
  return mesh;
}

TEST(ContactSurface, of_a_curve_has_one_node_a_vertex_and_mean_normals) {
  SolidMesh mesh = bent(8, pi / 2);
  const ContactSurface surface = surface_of(mesh, {low_z});
  EXPECT_EQ(surface.node_count(), 9 * 4);
  for (int i = 0; i < surface.node_count(); ++i) {
    const Vector3d x = mesh.vertices.col(surface.vertex[i]);
    const Vector3d inward = -Vector3d(x.x(), 0, x.z()).normalized();
    // at the ends the mean of one side only
    EXPECT_GT(surface.normal.col(i).dot(inward), std::cos(0.6 * pi / 16));
  }
  // its edges turn by 45 degrees
  EXPECT_EQ(surface_of(bent(2, pi / 2), {low_z}).node_count(), 4 * 4);
}

TEST(ContactSurface, frames_are_orthonormal_whatever_the_normal) {
  std::mt19937 random(3);
  ContactSurface surface;
  surface.vertex = VectorXi::Zero(1);
  for (int k = 0; k < 100; ++k) {
    surface.normal = random_vector(3, random).normalized();
    if (k % 10 == 0) surface.normal = Vector3d::Unit(k / 10 % 3);
    const Matrix3d frame = surface.frame(0);
    EXPECT_LT((frame.transpose() * frame - Matrix3d::Identity()).norm(), 1e-15);
    EXPECT_EQ(frame.col(0), surface.normal.col(0));
    EXPECT_LT((frame.col(1).cross(frame.col(0)) - frame.col(2)).norm(), 1e-15);
  }
}

TEST(ContactSurface, takes_given_directions_that_point_outward) {
  const SolidMesh mesh = bent(6, 1);
  const Facets<3> faces = facets_of(mesh);
  Matrix3Xd direction = -mesh.vertices;
  direction.row(1).setZero();
  const ContactSurface surface = surface_along(mesh, faces, {low_z}, direction);
  for (int i = 0; i < surface.node_count(); ++i)
    EXPECT_NEAR(surface.normal.col(i).norm(), 1, 1e-15);
  EXPECT_NE(refusal([&] {
              surface_along(mesh, faces, {low_z}, -direction);
            }).find("does not point out of the body"),
            std::string::npos);
}

TEST(ContactSurface, refuses_labels_that_are_nowhere) {
  const SolidMesh mesh = brick({1, 1, 1}, {1, 1, 1});
  EXPECT_EQ(refusal([&] { surface_of(mesh, {7}); }),
            "label 7 is on no boundary face of the mesh");
  EXPECT_EQ(refusal([&] { surface_of(mesh, {}); }), "no label is given");
}

}  // namespace
}  // namespace ffcontact
