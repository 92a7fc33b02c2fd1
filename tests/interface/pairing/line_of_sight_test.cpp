// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/line_of_sight.hpp"

#include <gtest/gtest.h>

namespace ffcontact {
namespace {

using Crossings = std::vector<Crossing>;

/// A body between two places of the line.
Crossings body(double from, double to) { return {{from, true}, {to, false}}; }

Crossings both(Crossings a, const Crossings& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

bool is_faced(double s, const Crossings& own, const Crossings& other) {
  return LineOfSight{own, other, false, 1e-9}.is_faced(s);
}
bool is_faced(double s, const Crossings& one) {
  return LineOfSight{one, one, true, 1e-9}.is_faced(s);
}

TEST(LineOfSight, faces_what_is_in_front_but_not_through_its_own_body) {
  EXPECT_TRUE(is_faced(0.3, body(-1, 0), body(0.3, 2)));
  EXPECT_TRUE(is_faced(0, body(-1, 0), body(0, 2)));
  EXPECT_FALSE(is_faced(0.3, both(body(-1, 0), body(0.1, 0.2)), body(0.3, 2)));
  // of a body that faces itself, another part
  const Crossings one = both(body(-1, 0), body(0.3, 2));
  EXPECT_TRUE(is_faced(0.3, one));
}

TEST(LineOfSight, faces_behind_it_what_it_overlaps) {
  EXPECT_TRUE(is_faced(-0.3, body(-1, 0), body(-0.3, 2)));
  // the other body is thinner than the overlap, or the own one is
  EXPECT_TRUE(is_faced(-0.3, body(-1, 0), body(-0.3, -0.2)));
  EXPECT_TRUE(is_faced(-0.3, body(-0.1, 0), body(-0.3, 2)));
  // a crack that is closed parts neither
  EXPECT_TRUE(
      is_faced(-0.3, both(body(-1, -0.1), body(-0.1, 0)), body(-0.3, -0.2)));
}

TEST(LineOfSight, faces_nothing_behind_through_itself) {
  const Crossings leaf = body(-0.2, 0);
  EXPECT_FALSE(is_faced(-0.2, leaf));
  EXPECT_FALSE(is_faced(-0.3, leaf, body(-0.5, -0.3)));
  // the own body goes on behind a hole
  EXPECT_FALSE(
      is_faced(-0.3, both(body(-1, -0.2), body(-0.1, 0)), body(-0.3, -0.25)));
  // a body with the other one merely behind it
  EXPECT_FALSE(is_faced(-0.3, body(-0.2, 0), body(-0.3, -0.1)));
}

TEST(LineOfSight, counts_a_body_that_overlaps_itself) {
  const Crossings closed_too_far = both(body(-1, 0), body(-0.01, 2));
  EXPECT_TRUE(is_faced(-0.01, closed_too_far));
  // two leaves of one body, one 0.05 in the other
  const Crossings leaves = both(body(-0.2, 0), body(-0.35, -0.15));
  EXPECT_FALSE(is_faced(-0.2, leaves));
}

}  // namespace
}  // namespace ffcontact
