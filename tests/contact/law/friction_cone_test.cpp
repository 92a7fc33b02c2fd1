// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/friction_cone.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/problems.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// One edge of the length 1, Coulomb's or Tresca's law, with a limit in every other case;
/// in every third case friction is the same at both ends.
Problem one_edge(Random& random) {
  Problem problem = body(rectangle(1, 1, 1, 1), material(1, 0));
  const auto any = [&]() -> VectorXd {
    VectorXd values = random_vector(2, random).cwiseAbs();
    if (random() % 3 == 0) values[1] = values[0];
    return values;
  };
  problem.law.friction = any();
  if (random() % 3 == 0) problem.law.slip_bound = any();
  if (random() % 2) problem.law.shear_limit = any();
  return problem;
}

/// Largest excess over the law on the edge, relative to the largest traction, by many
/// points on it.
double sampled_defect(const Problem& problem, const Vector4d& r) {
  const ContactLaw<2>& law = problem.law;
  const auto at = [&](const VectorXd& nodal, double s) {
    return (1 - s) * nodal[problem.line.edge_node(0, 0)] +
           s * nodal[problem.line.edge_node(1, 0)];
  };
  double excess = 0;
  for (int k = 0; k <= 1000; ++k) {
    const double s = k / 1000.0, rn = (1 - s) * r[0] + s * r[2],
                 rt = std::abs((1 - s) * r[1] + s * r[3]);
    const double bound = law.tresca()
                             ? at(law.slip_bound, s)
                             : at(law.friction, s) * std::max(0.0, -rn);
    excess = std::max({excess, rn, rt - bound});
    if (law.limited()) excess = std::max(excess, rt - at(law.shear_limit, s));
  }
  return excess / r.cwiseAbs().maxCoeff();
}

double defect(const Problem& problem, const Vector4d& r) {
  ContactDensities densities{Matrix2Xd(2, 1), Matrix2Xd(2, 1)};
  set_end_values(densities, 0, r);
  return cone_defect(problem.line, problem.law, densities);
}

/// Under compression; a pull is one at its largest at least.
RC_GTEST_PROP(FrictionCone, defect_is_the_largest_on_the_edge,
              (Random random)) {
  const Problem problem = one_edge(random);
  Vector4d r = random_vector(4, random);
  r[0] = -std::abs(r[0]);
  r[2] = -std::abs(r[2]);
  const double found = defect(problem, r), sampled = sampled_defect(problem, r);
  RC_ASSERT(found >= sampled - 1e-14);
  RC_ASSERT(found <= sampled + 1e-5);
  r[2] *= -1;
  RC_ASSERT(defect(problem, r) * r.cwiseAbs().maxCoeff() >= r[2] * (1 - 1e-15));
}

/// With s from one end or the other, mu |r_n| = s^2 and r_t = 1.5 s differ most at 3/4.
TEST(FrictionCone, defect_may_be_the_largest_between_the_ends) {
  Problem problem = body(rectangle(1, 1, 1, 1), material(1, 0));
  for (const int end : {0, 1}) {
    problem.law.friction = VectorXd::Zero(2);
    problem.law.friction[problem.line.edge_node(end, 0)] = 1;
    Vector4d r = Vector4d::Zero();
    r.segment<2>(2 * end) << -1, 1.5;
    EXPECT_NEAR(defect(problem, r), 9.0 / 16 / 1.5, 1e-15) << end;
  }
}

/// What C r >= d accepts is in the cone; what is 1.5 % inside it is accepted.
RC_GTEST_PROP(FrictionCone, inequalities_are_hardly_less_than_the_cone,
              (Random random)) {
  const Problem problem = one_edge(random);
  const EdgeCone edge = edge_cone(problem.line, problem.law, 0);
  int accepted = 0;
  for (int k = 0; k < 200; ++k) {
    Vector4d r = random_vector(4, random);
    r[0] = -std::abs(r[0]);
    r[2] = -std::abs(r[2]);
    const bool inside = ((edge.C * r - edge.d).array() >= 0).all();
    accepted += inside;
    if (inside) RC_ASSERT(defect(problem, r) <= 1e-15);
    const Vector4d more(r[0], 1.02 * r[1], r[2], 1.02 * r[3]);
    if (defect(problem, more) == 0) RC_ASSERT(inside);
  }
  RC_CLASSIFY(accepted > 0);
}

RC_GTEST_PROP(FrictionCone, clamped_values_are_in_the_cone, (Random random)) {
  const Problem problem = one_edge(random);
  const Vector4d r = random_vector(4, random),
                 c = clamped_to_cone(problem.line, problem.law, 0, r);
  RC_ASSERT(defect(problem, c) <= 1e-15);
  RC_ASSERT(c[0] == std::min(r[0], 0.0) && c[2] == std::min(r[2], 0.0));
  RC_ASSERT((clamped_to_cone(problem.line, problem.law, 0, c) - c).norm() <
            1e-14);
}

TEST(FrictionCone, bound_is_the_least_of_law_and_limit) {
  FrictionCone cone;
  EXPECT_TRUE(cone.frictionless());
  cone.cohesion = 1;
  cone.friction = 0.5;
  cone.limit = 3;
  EXPECT_EQ(cone.bound(-2), 2);
  EXPECT_EQ(cone.bound(-9), 3);
  EXPECT_EQ(cone.bound(5), 1);
  EXPECT_EQ(cone.clamped({5, -7}), Vector2d(0, -1));
  EXPECT_FALSE(cone.at_limit(-4));
  EXPECT_TRUE(cone.at_limit(-4.1));
  cone.limit = 0;
  EXPECT_TRUE(cone.frictionless());
}

}  // namespace
}  // namespace ffcontact
