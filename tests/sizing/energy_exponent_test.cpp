// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/energy_exponent.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"

namespace ffcontact::test {
namespace {

/// The energies between radii 1, 1.25, 1.25^2, ... of which W(r) = r^(2 alpha).
Neighbourhood power(double alpha, int radii) {
  Neighbourhood near;
  double r = 1, within = 0;
  for (int k = 0; k < radii; ++k, r *= 1.25) {
    const double W = std::pow(r, 2 * alpha);
    near.push_back({r, W - within});
    within = W;
  }
  return near;
}

RC_GTEST_PROP(EnergyExponent, of_a_power_is_half_of_it, (Random random)) {
  const double alpha = *real(0.11, 0.99);
  Neighbourhood near = power(alpha, *rc::gen::inRange(4, 20));
  const double largest = near.back().distance;
  shuffle(near, random);
  near.push_back({2 * largest, 1});  // beyond the largest radius
  RC_ASSERT(std::abs(fitted_exponent(near, 1, largest) - alpha) < 1e-12);
}

TEST(EnergyExponent, is_kept_to_what_coarse_meshes_can_say) {
  EXPECT_EQ(fitted_exponent(power(1.5, 8), 1, 4.7), 1);
  EXPECT_EQ(fitted_exponent(power(0.02, 8), 1, 4.7), 0.1);
}

/// By hand for W = 1, 1, 1, 4.
TEST(EnergyExponent, is_of_the_nearest_line) {
  const Neighbourhood near{{1, 1}, {1.8, 3}};
  // radii 1, 1.25, 1.5625, 1.953125: the line's slope is 0.3 log 4 a step
  EXPECT_NEAR(fitted_exponent(near, 1, 2),
              0.5 * 0.3 * std::log(4) / std::log(1.25), 1e-12);
}

TEST(EnergyExponent, is_one_where_less_than_four_radii_have_energy) {
  EXPECT_EQ(fitted_exponent(power(0.5, 8), 1, 1.9), 1);
  EXPECT_NEAR(fitted_exponent(power(0.5, 8), 1, 1.96), 0.5, 1e-12);
  // radii of 0.25 1.25^k, of which those above 1 have energy
  EXPECT_EQ(fitted_exponent(power(0.5, 8), 0.25, 2.3), 1);
  EXPECT_NEAR(fitted_exponent(power(0.5, 8), 0.25, 2.4), 0.5, 1e-12);
  EXPECT_EQ(fitted_exponent({}, 1, 100), 1);
}

}  // namespace
}  // namespace ffcontact::test
