// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/packed.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

TEST(Packed, values_are_one_below_the_other) {
  EXPECT_EQ(packed(std::vector<int>{3, 1, 2}), Vector3i(3, 1, 2));
  EXPECT_EQ(packed(std::vector<double>{}).size(), 0);
}

TEST(Packed, vectors_are_one_beside_the_other) {
  Matrix2d expected;
  expected << 1, 3, 2, 4;
  EXPECT_EQ(packed(std::vector<Vector2d>{{1, 2}, {3, 4}}), expected);
  const Matrix2Xd none = packed(std::vector<Vector2d>{});
  EXPECT_EQ(none.cols(), 0);
}

TEST(Packed, entries_at_one_place_are_added) {
  const Triplets entries{{0, 1, 2.0}, {1, 0, 5.0}, {0, 1, 3.0}};
  Matrix<double, 2, 3> expected;
  expected << 0, 5, 0, 5, 0, 0;
  EXPECT_EQ(MatrixXd(packed(2, 3, entries)), expected);
}

}  // namespace
}  // namespace ffcontact
