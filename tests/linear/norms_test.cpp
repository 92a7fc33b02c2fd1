// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/norms.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

TEST(Norms, of_nothing_are_zero) {
  EXPECT_EQ(max_norm(VectorXd(0)), 0);
  EXPECT_EQ(max_norm(MatrixXd(3, 0)), 0);
  EXPECT_EQ(max_norm(Vector2d(1, -4)), 4);
}

TEST(Norms, of_a_box_are_its_sides) {
  Matrix2Xd points(2, 3);
  points << 1, -2, 0, 5, 5, 7;
  EXPECT_EQ(box_sides(points), Vector2d(3, 2));
}

}  // namespace
}  // namespace ffcontact
