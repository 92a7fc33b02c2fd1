// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/edge_range.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(EnclosingRange, is_the_chord_where_the_samples_are_on_it) {
  const EdgeRange range = enclosing_range(VectorXd::LinSpaced(9, 0.3, 0.7));
  EXPECT_EQ(range.least, Vector2d(0.3, 0.7));
  EXPECT_EQ(range.most, Vector2d(0.3, 0.7));
}

RC_GTEST_PROP(EnclosingRange, encloses_the_samples, (Random random)) {
  const MatrixXd samples = random_matrix(9, 3, random).cwiseAbs();
  const EdgeRange range = enclosing_range(samples);
  RC_ASSERT(range.least.minCoeff() >= 0);
  for (int e = 0; e < 3; ++e)
    for (int k = 0; k < 9; ++k) {
      const Vector2d at(1 - k / 8., k / 8.);
      RC_ASSERT(at.dot(range.least.col(e)) <= samples(k, e) + 1e-15);
      RC_ASSERT(at.dot(range.most.col(e)) >= samples(k, e) - 1e-15);
    }
}

TEST(EdgeRange, is_refused_where_it_does_not_fit) {
  EdgeRange range{Matrix2Xd::Ones(2, 3), Matrix2Xd::Ones(2, 3)};
  const auto said = [&] {
    return refusal([&] { require_valid("mu", range, 3); });
  };
  EXPECT_EQ(said(), "accepted");
  range.most(1, 2) = -1;
  EXPECT_EQ(said(), "mu must be finite and not negative, but value 5 is -1");
  range.most.resize(2, 2);
  EXPECT_EQ(said(), "mu has 2 values where 3 are needed");
  range = {};
  EXPECT_EQ(said(), "accepted");
}

}  // namespace
}  // namespace ffcontact
