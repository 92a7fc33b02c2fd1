// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/traction_oscillation.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "support/random.hpp"
#include "support/solid_bodies.hpp"
#include "support/tetrahedra.hpp"
#include "support/traction_constant.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// kappa_k^2 / (1 - 1/k), which falls with k.
double bound_of_subdivision(int k) {
  return LeastStress(divided_tetrahedron(k), high_x).largest_ratio() /
         (1 - 1.0 / k);
}

TEST(TractionOscillation, constant_is_that_of_a_divided_face) {
  EXPECT_NEAR(bound_of_subdivision(3), 2.789, 1e-3);
  EXPECT_LT(bound_of_subdivision(4), traction_constant);
  EXPECT_GT(bound_of_subdivision(4), traction_constant - 0.01);
}

}  // namespace
}  // namespace ffcontact
