// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/covered_faces.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

TEST(CoveredFaces, are_those_whose_parts_are_all_of_them) {
  Matrix3Xd half(3, 3), other(3, 3), quarter(3, 4);
  half << 1, 0, 0, 0, 1, 0.5, 0, 0, 0.5;
  other << 1, 0, 0, 0, 0.5, 0, 0, 0.5, 1;
  quarter << 1, 0.5, 0.25, 0.5, 0, 0.5, 0.375, 0, 0, 0, 0.375, 0.5;
  CoveredFaces faces;
  faces.add(3, half);
  EXPECT_FALSE(faces.covers(3));
  faces.add(3, other);
  EXPECT_TRUE(faces.covers(3));
  EXPECT_TRUE(faces.covers_all());
  faces.add(8, quarter);
  EXPECT_TRUE(faces.covers(3));
  EXPECT_FALSE(faces.covers(8));
  EXPECT_FALSE(faces.covers_all());
  EXPECT_EQ(faces.count(), 2);
}

}  // namespace
}  // namespace ffcontact
