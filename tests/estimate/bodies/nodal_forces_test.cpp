// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/nodal_forces.hpp"

#include <gtest/gtest.h>

#include "support/problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(NodalForces, of_a_constant_traction_are_half_an_edge_each) {
  const Problem problem = body(rectangle(2, 1, 4, 1), material(1, 0));
  const ContactDensities densities{Matrix2Xd::Constant(2, 2, -3),
                                   Matrix2Xd::Constant(2, 2, 1)};
  const VectorXd forces = nodal_forces(problem.mesh, problem.line, densities);
  EXPECT_LT(
      (forces.head<6>() - (VectorXd(6) << 1, 3, 2, 6, 1, 3).finished()).norm(),
      1e-14);
  EXPECT_TRUE(forces.tail(6).isZero(0));
}

}  // namespace
}  // namespace ffcontact
