// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/cones_of_law.hpp"

#include <gtest/gtest.h>

#include "support/problems.hpp"
#include "support/random.hpp"
#include "support/solid_problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(ConesOfLaw, coulombs_bound_is_friction_times_compression) {
  const Problem problem = example_1(Multiplier::force, 2);
  const NodalLaw law = nodal_law(problem.law, problem.line);
  EXPECT_EQ(law.cone[0].bound(-4), 2);
  EXPECT_EQ(law.cone[0].bound(4), 0);
  EXPECT_FALSE(law.cone[0].frictionless());
}

TEST(ConesOfLaw, trescas_bound_is_in_the_units_of_the_multiplier) {
  Problem problem = example_1(Multiplier::pressure, 2);  // four edges of 20 mm
  problem.law.slip_bound = everywhere(problem.line, 3);
  EXPECT_EQ(nodal_law(problem.law, problem.line).cone[1].bound(-7), 3);
  problem.law.multiplier = Multiplier::force;
  EXPECT_DOUBLE_EQ(nodal_law(problem.law, problem.line).cone[0].bound(-7), 30);
  EXPECT_DOUBLE_EQ(nodal_law(problem.law, problem.line).cone[1].bound(-7), 60);
}

TEST(ConesOfLaw, has_bounds_of_nodal_forces_on_a_surface) {
  Random random(1);
  const ContactSurface surface = SolidProblem(irregular_solid(random)).surface;
  const int nodes = surface.node_count();
  ContactLaw<3> law;
  law.friction = VectorXd::Constant(nodes, 0.5);
  law.shear_limit = VectorXd::Constant(nodes, 3);
  const auto force = [&](double Pn) {
    return nodal_law(law, surface).cone[2].bound(Pn);
  };
  const auto traction = [&](double pressure) {
    return law_cones(law)[2].bound(pressure);
  };
  const double area = surface.area[2];
  EXPECT_DOUBLE_EQ(force(-area), area / 2);
  EXPECT_DOUBLE_EQ(traction(-1), 0.5);
  EXPECT_DOUBLE_EQ(force(-1e9), 3 * area);
  EXPECT_EQ(traction(-1e9), 3);
  law.slip_bound = VectorXd::Constant(nodes, 2);
  EXPECT_DOUBLE_EQ(force(-1e9), 2 * area);
  EXPECT_EQ(traction(-1e9), 2);
}

}  // namespace
}  // namespace ffcontact
