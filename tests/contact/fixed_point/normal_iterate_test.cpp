// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/fixed_point/normal_iterate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ffcontact {
namespace {

TEST(NormalIterate, takes_the_whole_way_while_steps_shrink) {
  NormalIterate g(1);
  for (const double image : {1.0, 1.5, 1.75}) {
    g.move_towards(VectorXd::Constant(1, image));
    EXPECT_EQ(g.value()[0], image);
  }
  EXPECT_EQ(g.history(), std::vector<double>({1, 0.5 / 1.5, 0.25 / 1.75}));
}

/// Each growing step is half as long as the one before, down to 1/32.
TEST(NormalIterate, is_damped_whenever_a_step_has_grown) {
  NormalIterate g(1);
  g.move_towards(VectorXd::Constant(1, 10));
  double damping = 1, change = 1;
  for (int k = 0; k < 8; ++k) {
    const double before = g.value()[0];
    change *= 1.5;
    damping = std::max(damping / 2, 1.0 / 32);
    const double image = before / (1 + change);  // |image - g|/image = change
    g.move_towards(VectorXd::Constant(1, image));
    EXPECT_NEAR(g.history().back(), change, 1e-9 * change);
    EXPECT_NEAR(g.value()[0], before + damping * (image - before),
                1e-12 * before);
  }
}

/// x -> -2 x moves away from its fixed point 0, halves of its steps do not.
TEST(NormalIterate, ends_where_undamped_steps_grow) {
  NormalIterate g(1);
  g.move_towards(VectorXd::Constant(1, 1));
  for (int k = 0; k < 60; ++k) {
    const double x = g.value()[0];
    g.move_towards(VectorXd::Constant(1, 3 - 2 * x));
  }
  EXPECT_NEAR(g.value()[0], 1, 1e-9);
}

TEST(NormalIterate, counts_steps_after_which_it_does_not_matter) {
  NormalIterate g(2);
  EXPECT_EQ(g.value(), VectorXd::Zero(2));
  g.stay();
  EXPECT_EQ(g.history(), std::vector<double>({0}));
  g.move_towards(VectorXd::Zero(2));
  EXPECT_EQ(g.history().back(), 0);
}

}  // namespace
}  // namespace ffcontact
