// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/uniqueness/critical_friction.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <limits>

#include "ffcontact/contact/stated_contact.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "support/bodies.hpp"
#include "support/coulomb.hpp"
#include "support/nested_reference.hpp"
#include "support/random.hpp"

namespace ffcontact::test {
namespace {

/// A triangle O A B on its side O A, displaced along O B, loaded on A B, that slips towards
/// A: with homogeneous strain
///     u = (e_11 x + e_12 y, e_22 y),   sigma_yy = -p,   sigma_xy = mu p.
/// The displacement (x - q y, 0) vanishes on O B where B is on x = q y, and with
///     q = (lambda (lambda + 2 G))^(1/2) / G
/// its stress is of rank one: A B, along (-G q, lambda), is free of it. On the base it has
/// r_n = lambda, r_t = G q, which is r_t = mu r_n for
///     mu = G q / lambda = (1 + 2 G / lambda)^(1/2) = ((1 - nu) / nu)^(1/2):
/// to a slipping state any multiple of it may be added.
struct SlippingTriangle {
  static constexpr double base = 10, stretch = 2e-3, pressure = 5;
  Material constants;
  double q =
      std::sqrt(constants.lambda * (constants.lambda + 2 * constants.G)) /
      constants.G;

  explicit SlippingTriangle(double nu) : constants(material(13e3, nu)) {}

  double critical() const { return constants.G * q / constants.lambda; }

  Vector2d top_vertex() const {
    const double height =
        constants.lambda * base / (q * (constants.lambda + constants.G));
    return {q * height, height};
  }

  Mesh mesh(int times) const {
    return subdivided(
        triangle({0, 0}, {base, 0}, top_vertex(), {bottom, right, left}),
        times);
  }

  Field solution(double mu) const {
    const auto [lambda, G] = constants;
    const double e_12 = mu * pressure / G,
                 e_22 = -(pressure + lambda * stretch) / (lambda + 2 * G);
    return [=](const Vector2d& x) {
      return Vector2d(stretch * x.x() + e_12 * x.y(), e_22 * x.y());
    };
  }

  Field free_motion() const {
    return
        [q = q](const Vector2d& x) { return Vector2d(x.x() - q * x.y(), 0); };
  }

  Problem problem(double mu, int times,
                  Multiplier multiplier = Multiplier::force) const {
    Problem problem = body(mesh(times), constants);
    const Vector2d along = top_vertex() - Vector2d(base, 0);
    const Vector2d normal = Vector2d(along.y(), -along.x()).normalized();
    const auto [lambda, G] = constants;
    const double s_xx = (lambda + 2 * G) * stretch +
                        lambda * solution(mu)({0, 1}).y(),
                 s_xy = mu * pressure;
    add_traction(problem, right,
                 {s_xx * normal.x() + s_xy * normal.y(),
                  s_xy * normal.x() - pressure * normal.y()});
    clamp(problem, left, solution(mu));
    set_friction(problem, mu);
    problem.law.multiplier = multiplier;
    return problem;
  }
};

/// What keeps a displacement from being a solution with these loads: forces where there
/// are none, and violations of the law, relative.
double solution_defect(const Problem& problem, const VectorXd& u) {
  const ElasticSystem system = problem.system();
  const VectorXd forces =
      stiffness(problem.mesh, problem.hooke) * u - problem.b;
  VectorXd free_forces = forces;
  for (Index dof = 0; dof < u.size(); ++dof)
    if (system.prescribed[dof]) free_forces[dof] = 0;
  Matrix2Xd P(2, problem.line.node_count());
  for (int i = 0; i < problem.line.node_count(); ++i) {
    const int v = problem.line.vertex[i];
    const Vector2d F = free_forces.segment<2>(2 * v);
    P.col(i) << F.dot(problem.line.normal.col(i)),
        F.dot(problem.line.tangent(i));
    free_forces.segment<2>(2 * v).setZero();
  }
  return std::max(free_forces.cwiseAbs().maxCoeff() / P.cwiseAbs().maxCoeff(),
                  stated_on_line(problem.line, problem.law, system, {})
                      .law_defect(u, P.reshaped()));
}

constexpr double tolerance = 1e-10;

class Triangle : public testing::TestWithParam<double> {};

TEST_P(Triangle, critical_coefficient_is_that_of_the_exact_family) {
  const SlippingTriangle triangle(GetParam());
  for (int times : {0, 1, 2, 3})
    for (Multiplier multiplier : {Multiplier::force, Multiplier::pressure}) {
      const Problem problem =
          triangle.problem(0.5 * triangle.critical(), times, multiplier);
      const double critical = critical_friction_of(problem, solved(problem));
      std::printf("nu %.2f, %d triangles: %.10f, exact %.10f\n", GetParam(),
                  problem.mesh.cell_count(), critical, triangle.critical());
      EXPECT_NEAR(critical / triangle.critical(), 1, 1e-8);
    }
}

TEST_P(Triangle, has_one_solution_below_it_and_a_family_at_it) {
  const SlippingTriangle triangle(GetParam());
  for (double part : {0.3, 0.7, 0.95, 1.0}) {
    const double mu = part * triangle.critical();
    const Problem problem = triangle.problem(mu, 2);
    const VectorXd u = nodal_values(problem.mesh, triangle.solution(mu));
    EXPECT_LT(solution_defect(problem, u), tolerance);
    const VectorXd shift = nodal_values(problem.mesh, triangle.free_motion());
    // r_n stays compression
    const double largest =
        SlippingTriangle::pressure / triangle.constants.lambda;
    for (double factor : {-largest, -0.1 * largest, 0.4 * largest}) {
      const double defect = solution_defect(problem, u + factor * shift);
      EXPECT_EQ(defect < tolerance, part == 1) << part << ": " << defect;
    }
    if (part == 1) continue;
    for (ContactState start : {ContactState::open, ContactState::stick,
                               ContactState::slip_forward}) {
      ContactSettings settings;
      settings.initial_state.assign(problem.line.node_count(), start);
      const ContactSolution<2> solution = solved(problem, settings);
      ASSERT_TRUE(solution.accepted(settings));
      EXPECT_LT(relative_difference(solution.displacement, u), 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(poisson, Triangle, testing::Values(0.2, 0.3, 0.45));

/// At a singular state with the motion u, forces r: |u|^2 = int r_t u_t = mu int r_n s u_t
/// <= mu kappa |u|^2 with sticking nodes held.
RC_GTEST_PROP(critical_friction, is_not_below_that_of_uniqueness,
              (Random random)) {
  Problem problem = body(irregular(*rc::gen::inRange(2, 8), 3, 6, 4, random),
                         material(1e3, *real(0, 0.48)));
  *rc::gen::arbitrary<bool>() ? clamp(problem, left)
                              : clamp(problem, top, [](const Vector2d&) {
                                  return Vector2d(1e-3, -1e-2);
                                });
  add_traction(problem, right, random_vector(2, random) * 5);
  set_friction(problem, *real(0.05, 1));
  const ContactSolution<2> solution = solved(problem);
  RC_PRE(solution.accepted({}));
  const double critical = critical_friction_of(problem, solution),
               kappa = kappa_of(problem, solution, StuckNodes::stick);
  RC_CLASSIFY(std::isfinite(critical), "finite");
  RC_ASSERT(critical >= (1 - 1e-6) / kappa);
}

/// Up to the coefficient found the determinant keeps its sign, beyond it has the other.
TEST(critical_friction, is_where_the_determinant_vanishes_first) {
  for (int cells : {4, 8}) {
    const Bodies two = example_3(Multiplier::force, cells, 2 * cells);
    const Problem& problem = two.problem;
    const ContactSolution<2> solution = solved(problem);
    const Condensed condensed(problem);
    const double critical = critical_friction_of(problem, solution);
    const auto determinant = [&](double mu) {
      NodalLaw law = condensed.law;
      for (FrictionCone& cone : law.cone) cone.friction = mu;
      return active_set_matrix(condensed.contact, law, solution.state)
          .determinant();
    };
    ASSERT_TRUE(std::isfinite(critical));
    for (double part : {0.0, 0.25, 0.5, 0.75, 0.999})
      EXPECT_GT(determinant(part * critical) / determinant(0), 0) << part;
    EXPECT_LT(determinant(1.001 * critical) / determinant(0), 0);
  }
}

TEST(critical_friction, is_infinite_without_slip_that_depends_on_pressure) {
  const double infinite = std::numeric_limits<double>::infinity();
  Problem problem = example_2(Multiplier::force, 0.8, 8);
  EXPECT_EQ(critical_friction_of(problem, solved(problem)), infinite);
  problem = example_1(Multiplier::force, 8);
  problem.law.slip_bound = everywhere(problem.line, 1);
  EXPECT_EQ(critical_friction_of(problem, solved(problem)), infinite);
  problem = SlippingTriangle(0.3).problem(0.5, 2);
  problem.law.shear_limit = everywhere(problem.line, 1e-3);
  EXPECT_EQ(critical_friction_of(problem, solved(problem)), infinite);
}

TEST(critical_friction, is_the_largest_of_coefficients_that_vary) {
  const SlippingTriangle triangle(0.3);
  Problem problem = triangle.problem(0.5, 2);
  const ContactSolution<2> solution = solved(problem);
  const double critical = critical_friction_of(problem, solution);
  problem.law.friction *= 0.25;
  EXPECT_NEAR(critical_friction_of(problem, solution) / critical, 1, 1e-10);
  problem.law.friction[0] *= 2;  // at the clamped vertex, where none slips
  EXPECT_NEAR(critical_friction_of(problem, solution) / critical, 2, 1e-10);
}

}  // namespace
}  // namespace ffcontact::test
