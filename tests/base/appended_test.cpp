// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/appended.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

TEST(Appended, values_and_columns_follow_those_that_are_there) {
  VectorXd values = Vector2d(1, 2);
  append(Vector2d(3, 4), values);
  EXPECT_EQ(values, Vector4d(1, 2, 3, 4));
  Matrix2Xd columns = Vector2d(1, 2);
  append(Matrix2Xd(Vector2d(3, 4)), columns);
  EXPECT_EQ(columns, (Matrix2d() << 1, 3, 2, 4).finished());
}

}  // namespace
}  // namespace ffcontact
