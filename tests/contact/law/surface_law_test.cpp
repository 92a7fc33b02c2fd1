// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/surface_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solid_problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A surface whose nodes have directions of their own.
ContactSurface rough_surface(Random& random) {
  SolidProblem problem(irregular_solid(random));
  ContactSurface surface = problem.surface;
  surface.normal += 0.2 * random_matrix(3, surface.node_count(), random);
  surface.normal.colwise().normalize();
  return surface;
}

TEST(SurfaceLaw, has_bounds_of_nodal_forces) {
  Random random(1);
  const ContactSurface surface = rough_surface(random);
  const int nodes = surface.node_count();
  SurfaceLaw law;
  law.friction = VectorXd::Constant(nodes, 0.5);
  law.shear_limit = VectorXd::Constant(nodes, 3);
  const auto force = [&](double Pn) {
    return nodal_law(law, surface).cone[2].bound(Pn);
  };
  const auto traction = [&](double pressure) {
    return law_cones(law, surface)[2].bound(pressure);
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

NodalLaw one_node(double friction) {
  NodalLaw law;
  law.cone.resize(1);
  law.cone[0].friction = friction;
  return law;
}

/// Of P = (-2, 0.6, 0.8) at the bound of mu = 1/2.
TEST(SurfaceLaw, violation_is_the_smaller_of_two_that_must_vanish) {
  const Vector3d P(-2, 0.6, 0.8), along = -Vector3d(0, 0.6, 0.8);
  const auto violation = [&](const Vector3d& force, const Vector3d& v) {
    return surface_violation(one_node(0.5), force, v, {10, 2});
  };
  EXPECT_LT(violation(P, 5 * along), 1e-15);
  EXPECT_NEAR(violation(P, -5 * along), 0.5, 1e-15);  // |v_t| < 2 |P_t|
  EXPECT_NEAR(violation(P, -50 * along), 1, 1e-15);   // 2 |P_t| < |v_t|
  EXPECT_NEAR(violation(P, {-3, 0, 0}), 0.3, 1e-15);  // |v_n| < |P_n|
  EXPECT_NEAR(violation(P, {-30, 0, 0}), 1, 1e-15);   // |P_n| < |v_n|
  EXPECT_NEAR(violation(P, {1, 0, 0}), 0.1, 1e-15);   // penetrates
  EXPECT_NEAR(violation({-2, 1.5, 0}, {0, 0, 0}), 0.25, 1e-15);
  EXPECT_NEAR(violation({1, 0, 0}, {0, 0, 0}), 0.5, 1e-15);
  EXPECT_EQ(violation({-2, std::nan(""), 0}, {0, 0, 0}), INFINITY);
}

TEST(SurfaceLaw, refuses_what_does_not_fit) {
  Random random(1);
  const ContactSurface surface = rough_surface(random);
  const int nodes = surface.node_count();
  const auto said = [&](const auto& change) {
    SurfaceLaw law;
    law.friction = VectorXd::Zero(nodes);
    change(law);
    return refusal([&] { require_valid(law, surface); });
  };
  EXPECT_EQ(said([](SurfaceLaw&) {}), "accepted");
  EXPECT_TRUE(
      says(said([](SurfaceLaw& l) { l.friction[1] = -1; }), "friction"));
  EXPECT_TRUE(
      says(said([](SurfaceLaw& l) { l.slip_bound.setZero(1); }), "slipbound"));
  EXPECT_TRUE(says(said([](SurfaceLaw& l) { l.shear_limit.setZero(2); }),
                   "shear limit"));
  EXPECT_TRUE(says(said([](SurfaceLaw& l) { l.gap.setZero(3); }), "gap"));
  EXPECT_TRUE(
      says(said([](SurfaceLaw& l) { l.previous.setZero(2, 3); }), "previous"));
  EXPECT_TRUE(says(said([&](SurfaceLaw& l) {
                     l.gap = VectorXd::Constant(nodes, std::nan(""));
                   }),
                   "gap"));
}

TEST(SurfaceLaw, measures_from_the_gap_and_the_step_before) {
  Random random(1);
  const ContactSurface surface = rough_surface(random);
  const int nodes = surface.node_count();
  const VectorXd u = random_vector(200, random);
  SurfaceLaw law;
  const Matrix3Xd plain = displacement_against_foundation(surface, law, u);
  law.gap = 4 * random_vector(nodes, random);
  law.previous = 3 * random_matrix(2, nodes, random);
  Matrix3Xd v = displacement_against_foundation(surface, law, u) - plain;
  v.row(0) += law.gap.transpose();
  v.bottomRows<2>() += law.previous;
  EXPECT_LT(v.norm(), 1e-14);
  EXPECT_EQ(largest_displacement(law, u), law.gap.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace ffcontact
