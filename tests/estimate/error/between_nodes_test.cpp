// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/estimate/error/face_fields.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A face under tractions and motions.
struct FieldsOnFace {
  BoundedTraction r;
  FaceMotion motion;

  void note_in(BetweenNodes& found, int face) const {
    note(r, motion, motion.normal, face, found);
  }
};

/// One direction and friction 1/2; pressed by 2 MPa, pulled back by 1 MPa, slipping by 3
/// mm, and beyond the gap by this much.
FieldsOnFace slipping(double penetration) {
  const Matrix3d normal = Vector3d(0, 0, -1).replicate<1, 3>(),
                 pull = Vector3d(0, -1, 0).replicate<1, 3>(),
                 moved = Vector3d(3, 0, -penetration).replicate<1, 3>(),
                 none = Matrix3d::Zero();
  const Eigen::RowVector3d pressed = Eigen::RowVector3d::Constant(-2),
                           bound = Eigen::RowVector3d::Constant(1),
                           zero = Eigen::RowVector3d::Zero();
  return {{{normal, pressed, pull}, bound}, {normal, moved, none, zero}};
}

/// f = c |w_t| + r_t . w_t + r_n w_n = 0 - 2 w_n.
TEST(BetweenNodes, integrand_is_negative_where_the_gap_is_passed) {
  BetweenNodes found;
  slipping(-0.25).note_in(found, 7);
  EXPECT_EQ(found.negative, 0);
  slipping(0.25).note_in(found, 8);
  slipping(0.125).note_in(found, 9);
  EXPECT_NEAR(found.negative, 0.5, 5e-15);  // friction of 1e-15 |r| more
  EXPECT_EQ(found.negative_facet, 8);
  EXPECT_EQ(found.turn, 0);
}

/// Of a face without tractions and at rest.
FieldsOnFace at_rest(const Matrix3Xd& normals) {
  const Matrix3Xd none = Matrix3Xd::Zero(3, 3);
  const Eigen::RowVector3d zero = Eigen::RowVector3d::Zero();
  return {{{normals, zero, none}, zero}, {normals, none, none, zero}};
}

/// Directions that turn by 2 a.
Matrix3Xd turning(double a) {
  Matrix3Xd normals = Matrix3Xd::Zero(3, 3);
  normals.row(0) << std::sin(a), -std::sin(a), -std::sin(a);
  normals.row(2).setConstant(std::cos(a));
  return normals;
}

TEST(BetweenNodes, turns_count_where_something_is_carried_or_penetrates) {
  for (const double a : {0.78, 0.79}) {
    FieldsOnFace fields = at_rest(turning(a));
    const double turn = a < 0.785 ? 0 : 2 * a;
    BetweenNodes found;
    fields.motion.jump.row(2).setConstant(-1);  // far from contact
    fields.note_in(found, 3);
    EXPECT_EQ(found.turn, 0);
    fields.motion.jump.row(2).setConstant(1);
    fields.note_in(found, 4);
    EXPECT_NEAR(found.turn, turn, 1e-15);
    EXPECT_EQ(found.turned_facet, turn > 0 ? 4 : 0);
    found = {};
    fields.motion.jump.setZero();
    fields.r.traction.pressing.setConstant(-1);
    fields.note_in(found, 5);
    EXPECT_NEAR(found.turn, turn, 1e-15);
    EXPECT_EQ(found.turned_facet, turn > 0 ? 5 : 0);
    EXPECT_EQ(found.negative, 0);
  }
}

TEST(BetweenNodes, slips_of_rounding_are_none) {
  EXPECT_EQ(slip_beyond(1e-13, 0.9e-13), 0);
  EXPECT_EQ(slip_beyond(1e-13, -2e-13), -2e-13);
}

}  // namespace
}  // namespace ffcontact
