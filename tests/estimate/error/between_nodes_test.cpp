// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/estimate/error/face_fields.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

FrictionCone with_friction(double mu) {
  FrictionCone cone;
  cone.friction = mu;
  return cone;
}

/// One direction and friction 1/2; pressed by 2 MPa, pulled back by 1 MPa, slipping by 3
/// mm, and beyond the gap by this much.
FaceFields slipping(double penetration) {
  FaceFields fields;
  fields.normal = Vector3d(0, 0, -1).replicate<1, 3>();
  fields.traction = Vector3d(-1, 0, 2).replicate<1, 3>();
  fields.motion = Vector3d(3, 0, -penetration).replicate<1, 3>();
  fields.cone.assign(3, with_friction(0.5));
  return fields;
}

/// f = c |w_t| + r_t . w_t + r_n w_n = 0 - 2 w_n.
TEST(BetweenNodes, integrand_is_negative_where_the_gap_is_passed) {
  BetweenNodes found;
  note(slipping(-0.25), slipping(0).normal, 7, found);
  EXPECT_EQ(found.negative, 0);
  note(slipping(0.25), slipping(0).normal, 8, found);
  note(slipping(0.125), slipping(0).normal, 9, found);
  EXPECT_NEAR(found.negative, 0.5, 5e-15);  // friction of 1e-15 |r| more
  EXPECT_EQ(found.negative_facet, 8);
  EXPECT_EQ(found.turn, 0);
}

/// Admissible at all nodes and with one direction, it is so between them.
RC_GTEST_PROP(BetweenNodes, integrand_is_not_negative_with_one_direction,
              (Random random)) {
  FaceFields fields;
  const Vector3d n = random_vector(3, random).normalized();
  fields.normal = n.replicate<1, 3>();
  fields.traction = fields.motion = random_matrix(3, 3, random);
  const double mu = *real(0, 2);
  fields.cone.assign(3, with_friction(mu));
  for (int k = 0; k < 3; ++k) {
    const double rn = -*real(0, 1), wn = -*real(0, 1);
    const Vector3d any = fields.traction.col(k),
                   rt = (any - any.dot(n) * n).normalized() * mu * rn,
                   other = random_vector(3, random);
    fields.traction.col(k) = rn * n + *real(0, 1) * rt;
    fields.motion.col(k) = wn * n + other - other.dot(n) * n;
  }
  BetweenNodes found;
  note(fields, fields.normal, 1, found);
  RC_ASSERT(found.negative < 1e-14);
  RC_ASSERT(found.turn == 0);
}

/// Of a face without tractions and at rest.
FaceFields without_friction(const Matrix3Xd& normals) {
  return {normals, Matrix3Xd::Zero(3, 3), Matrix3Xd::Zero(3, 3),
          std::vector<FrictionCone>(3, with_friction(0))};
}

/// Directions that turn by 2 a.
Matrix3Xd turning(double a) {
  Matrix3Xd normals = Matrix3Xd::Zero(3, 3);
  normals.row(0) << std::sin(a), -std::sin(a), -std::sin(a);
  normals.row(2).setConstant(std::cos(a));
  return normals;
}

TEST(BetweenNodes, turns_count_where_something_is_carried_or_penetrates) {
  const double a = 0.1;
  const Matrix3Xd normals = turning(a);
  FaceFields fields = without_friction(normals);
  BetweenNodes found;
  fields.motion.row(2).setConstant(-1);  // far from contact
  note(fields, normals, 3, found);
  EXPECT_EQ(found.turn, 0);
  fields.motion.row(2).setConstant(1);
  note(fields, normals, 4, found);
  EXPECT_NEAR(found.turn, 2 * a, 1e-15);
  EXPECT_EQ(found.turned_facet, 4);
  found = {};
  fields.motion.setZero();
  fields.traction = -normals;
  note(fields, normals, 5, found);
  EXPECT_NEAR(found.turn, 2 * a, 1e-15);
  EXPECT_EQ(found.turned_facet, 5);
  EXPECT_EQ(found.negative, 0);
}

/// Both ends are pressed along their directions and the first one slips along its tangent:
/// f = r . w = -s (1 - s) sin 2a between them.
TEST(BetweenNodes, integrand_is_negative_where_directions_turn) {
  const double a = 0.1;
  const Matrix3Xd normals = turning(a);
  FaceFields fields = without_friction(normals);
  fields.traction = -normals;
  fields.motion.col(0) << -std::cos(a), 0, std::sin(a);
  BetweenNodes found;
  note(fields, normals, 6, found);
  EXPECT_NEAR(found.negative, std::sin(2 * a) / 4, 1e-15);
  EXPECT_EQ(found.negative_facet, 6);
}

TEST(BetweenNodes, turns_below_1e11_are_rounding) {
  for (const double a : {4e-12, 6e-12}) {
    const Matrix3Xd normals = turning(a);
    FaceFields fields = without_friction(normals);
    fields.traction = -normals;
    BetweenNodes found;
    note(fields, normals, 0, found);
    EXPECT_NEAR(found.turn, a > 5e-12 ? 2 * a : 0, 1e-18);
  }
}

TEST(BetweenNodes, slips_of_rounding_are_none) {
  EXPECT_EQ(slip_beyond(1e-13, 0.9e-13), 0);
  EXPECT_EQ(slip_beyond(1e-13, -2e-13), -2e-13);
}

}  // namespace
}  // namespace ffcontact
