// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/contact_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/problems.hpp"
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

std::string refusal_of(const ContactLaw<2>& law, const ContactLine& line) {
  return refusal([&] { require_valid(law, line); });
}

TEST(ContactLaw, gap_and_previous_displacement_are_taken_off) {
  const Problem problem = example_1(Multiplier::force, 2);
  ContactLaw<2> law = problem.law;
  law.gap = VectorXd::LinSpaced(5, 0, 4);
  law.previous = everywhere(problem.line, 0.5);
  const VectorXd u = nodal_values(
      problem.mesh, [](const Vector2d&) { return Vector2d(2, -3); });
  const Matrix2Xd against =
      displacement_against_foundation(problem.line, law, u);
  // n = (0, -1), t = (1, 0)
  for (int i = 0; i < 5; ++i) EXPECT_EQ(against.col(i), Vector2d(3 - i, 1.5));
}

TEST(ContactLaw, refuses_friction_that_is_negative_or_not_a_number) {
  const Problem problem = example_1(Multiplier::force, 2);
  ContactLaw<2> law = problem.law;
  law.friction[3] = -0.1;
  EXPECT_EQ(refusal_of(law, problem.line),
            "friction must be finite and not negative, but value 3 is -0.1");
  law.friction[3] = std::nan("");
  EXPECT_EQ(refusal_of(law, problem.line),
            "friction must be finite and not negative, but value 3 is nan");
  law.friction.resize(4);
  EXPECT_EQ(refusal_of(law, problem.line),
            "friction has 4 values where 5 are needed");
}

TEST(ContactLaw, refuses_bad_slip_bounds_and_gaps) {
  const Problem problem = example_1(Multiplier::force, 2);
  ContactLaw<2> law = problem.law;
  law.slip_bound = everywhere(problem.line, -1);
  EXPECT_EQ(refusal_of(law, problem.line),
            "slipbound must be finite and not negative, but value 0 is -1");
  law = problem.law;
  law.gap = everywhere(problem.line, std::nan(""));
  EXPECT_EQ(refusal_of(law, problem.line),
            "gap[0] is nan, not a finite number");
  law.gap = VectorXd::Zero(2);
  EXPECT_EQ(refusal_of(law, problem.line),
            "gap has 2 values where 5 are needed");
}

TEST(ContactLaw, of_a_surface_refuses_what_does_not_fit) {
  Random random(1);
  const ContactSurface surface = rough_surface(random);
  const int nodes = surface.node_count();
  const auto said = [&](const auto& change) {
    ContactLaw<3> law;
    law.friction = VectorXd::Zero(nodes);
    change(law);
    return refusal([&] { require_valid(law, surface); });
  };
  EXPECT_EQ(said([](ContactLaw<3>&) {}), "accepted");
  EXPECT_TRUE(
      says(said([](ContactLaw<3>& l) { l.friction[1] = -1; }), "friction"));
  EXPECT_TRUE(says(said([](ContactLaw<3>& l) { l.slip_bound.setZero(1); }),
                   "slipbound"));
  EXPECT_TRUE(says(said([](ContactLaw<3>& l) { l.shear_limit.setZero(2); }),
                   "shear limit"));
  EXPECT_TRUE(says(said([](ContactLaw<3>& l) { l.gap.setZero(3); }), "gap"));
  EXPECT_TRUE(says(said([](ContactLaw<3>& l) { l.previous.setZero(2, 3); }),
                   "previous"));
  EXPECT_TRUE(says(said([&](ContactLaw<3>& l) {
                     l.gap = VectorXd::Constant(nodes, std::nan(""));
                   }),
                   "gap"));
}

TEST(ContactLaw, of_a_surface_measures_from_the_gap_and_the_step_before) {
  Random random(1);
  const ContactSurface surface = rough_surface(random);
  const int nodes = surface.node_count();
  const VectorXd u = random_vector(200, random);
  ContactLaw<3> law;
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
