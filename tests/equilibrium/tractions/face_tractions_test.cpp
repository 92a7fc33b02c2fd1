// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(FaceTractions, contact_is_linear_between_the_nodes) {
  const SolidMesh mesh = brick({1, 1, 1}, {1, 1, 1});
  const Facets<3> faces = facets_of(mesh);
  const ContactSurface surface = contact_surface(mesh, faces, {low_z});
  const FaceTractions none = given_tractions(
      mesh, faces, std::vector<char>(24, 0), FaceMoments::Zero(9, 12));
  Matrix3Xd r(3, 4);
  for (int i = 0; i < 4; ++i) {
    const Vector3d x = mesh.vertices.col(surface.vertex[i]);
    r.col(i) << -1 - x.x(), 2 * x.y(), 3;
  }
  const FaceTractions boundary = with_contact(none, mesh, faces, surface, r);
  // n = -z, t1 = x, t2 = y: int of (2 y, 3, 1 + x) and of its work on x
  Vector3d force = Vector3d::Zero();
  double work = 0;
  for (int f = 0; f < faces.count(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Vector3d moment = boundary.moments.col(f).segment<3>(3 * k);
      force += moment;
      work += mesh.vertices(0, faces.vertices(k, f)) * moment.z();
    }
  EXPECT_LT((force - Vector3d(1, 3, 1.5)).norm(), 1e-14);
  EXPECT_NEAR(work, 0.5 + 1.0 / 3, 1e-14);
}

TEST(FaceTractions, tractions_follow_the_order_of_the_face) {
  std::mt19937 random(1);
  const SolidMesh mesh = shuffled(brick({1, 1, 1}, {1, 1, 1}), random);
  const Facets<3> faces = facets_of(mesh);
  FaceMoments given = FaceMoments::Zero(9, 12);
  for (int f = 0; f < 12; ++f)
    for (int k = 0; k < 3; ++k)
      given.col(f).segment<3>(3 * k).setConstant(mesh.boundary(k, f));
  const FaceTractions boundary =
      given_tractions(mesh, faces, std::vector<char>(24, 0), given);
  for (int f = 0; f < faces.count(); ++f) {
    if (!faces.on_boundary(f)) continue;
    for (int row = 0; row < 9; ++row)
      EXPECT_EQ(boundary.moments(row, f), faces.vertices(row / 3, f));
  }
}

TEST(FaceTractions, refuses_values_that_are_not_finite) {
  const SolidMesh mesh = brick({1, 1, 1}, {1, 1, 1});
  FaceMoments given = FaceMoments::Zero(9, 12);
  given(3, 2) = std::nan("");
  EXPECT_TRUE(says(refusal([&] {
                     given_tractions(mesh, facets_of(mesh),
                                     std::vector<char>(24, 0), given);
                   }),
                   "traction[21]"));
}

}  // namespace
}  // namespace ffcontact
