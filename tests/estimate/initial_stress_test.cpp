// SPDX-License-Identifier: GPL-3.0-or-later
// The estimate for sigma = C eps(u) + tau0, tau0 = sigma0 - C eps0.
#include "support/initial_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/smooth_problem.hpp"

namespace ffcontact {
namespace {

using namespace test;

const Material steel = material(200e3, 0.3);
constexpr double width = 40, height = 30, free_strain = 1e-3;

LinearStresses<2> heated(const Mesh& mesh) {
  const Vector3d tau = -steel.hooke() * Vector3d(free_strain, free_strain, 0);
  return at_vertices(mesh, [=](const Vector2d&) { return tau; });
}

/// On rollers at the left and at the top, a gap above the foundation.
Problem on_rollers(double gap) {
  Random random(31);
  Problem problem = body(irregular(5, 4, width, height, random), steel);
  prescribe(problem, left, 0);
  prescribe(problem, top, 1);
  set_friction(problem, 0.3);
  problem.law.gap = everywhere(problem.line, gap);
  return problem;
}

TEST(InitialStrain, of_a_free_body_leaves_no_stress) {
  Problem problem = on_rollers(2 * free_strain * height);
  const LinearStresses<2> tau = heated(problem.mesh);
  add_initial_stress(problem, tau);
  const Estimate<2> estimate = estimated(problem, solved(problem), tau);
  EXPECT_TRUE(estimate.admissible) << estimate.reason;
  EXPECT_EQ(estimate.e, 0);
  for (const SubcellStress<2>& stress : estimate.stress)
    EXPECT_TRUE(stress.isZero(0));
}

/// Half of the expansion closes the gap, the other half presses: sigma_yy = (C22 - C12^2 /
/// C11) (gap / height - eps0).
TEST(InitialStrain, of_a_confined_body_presses_it) {
  const double gap = 0.5 * free_strain * height;
  const Matrix3d C = steel.hooke();
  const double pressure =
      (C(1, 1) - C(0, 1) * C(0, 1) / C(0, 0)) * (gap / height - free_strain);
  for (Multiplier multiplier : both_multipliers) {
    Problem problem = on_rollers(gap);
    set_friction(problem, 0);
    problem.law.multiplier = multiplier;
    const LinearStresses<2> tau = heated(problem.mesh);
    add_initial_stress(problem, tau);
    const Estimate<2> estimate = estimated(problem, solved(problem), tau);
    EXPECT_TRUE(estimate.admissible) << estimate.reason;
    const double scale = estimate.e / estimate.relative;
    EXPECT_LT(estimate.elastic, 1e-10 * scale);
    EXPECT_LT(std::abs(estimate.contact), 1e-14 * scale * scale);
    for (const SubcellStress<2>& stress : estimate.stress)
      EXPECT_LT((stress.colwise() - Vector3d(0, pressure, 0)).norm(),
                1e-9 * std::abs(pressure));
  }
}

/// Nothing moves: the tractions balance sigma0.
TEST(InitialStress, in_balance_with_tractions_is_exact) {
  const Vector3d sigma(-30, -50, 10);
  Random random(32);
  Problem problem = body(irregular(5, 4, width, height, random), steel);
  add_traction(problem, left, -Vector2d(sigma[0], sigma[2]));
  add_traction(problem, right, Vector2d(sigma[0], sigma[2]));
  add_traction(problem, top, Vector2d(sigma[2], sigma[1]));
  set_friction(problem, 0.5);
  const LinearStresses<2> tau =
      at_vertices(problem.mesh, [=](const Vector2d&) { return sigma; });
  add_initial_stress(problem, tau);
  const ContactSolution<2> solution = solved(problem);
  const Estimate<2> estimate = estimated(problem, solution, tau);
  EXPECT_TRUE(estimate.admissible) << estimate.reason;
  EXPECT_LT(estimate.relative, 1e-11);
  EXPECT_LT((solution.pressure.colwise() - Vector2d(sigma[1], -sigma[2]))
                .cwiseAbs()
                .maxCoeff(),
            1e-9 * sigma.norm());
}

/// An exact solution with u of the cubic potential and sigma = C eps(u) + tau0 linear, in
/// balance with a constant body force; all data are those of the discrete problem.
struct Exact {
  Manufactured total;
  InitialField tau;
  Vector2d force;
};

/// tau0 has no shear on the contact line and presses there.
Exact exact_solution(double nu, Random& random) {
  const Manufactured cubic = cubic_solution(nu);
  const Vector2d g = random_vector(2, random) * 4, h = random_vector(2, random);
  const double shear = random_vector(1, random)[0];
  const InitialField tau = [=](const Vector2d& x) {
    return Vector3d(g.dot(x), h.dot(x) - 4, shear * x.y());
  };
  const Matrix3d compliance = cubic.material.hooke().inverse();
  Manufactured total = cubic;
  total.strain = [=](const Vector2d& x) -> Vector3d {
    return cubic.strain(x) + compliance * tau(x);
  };
  return {total, tau, -Vector2d(g.x() + shear, h.y())};
}

/// (2.20) in energy: what tau0 varies by in a triangle is a part of both errors.
RC_GTEST_PROP(InitialStress, that_varies_is_bounded_and_tight,
              (Random random)) {
  const Exact exact = exact_solution(*real(0, 0.4), random);
  Problem problem = loaded_in_contact(
      exact.total, irregular(*rc::gen::inRange(3, 7), 4, 2, 2, random));
  const LinearStresses<2> tau = at_vertices(problem.mesh, exact.tau);
  add_initial_stress(problem, tau);
  add_body_force(problem, exact.force);
  problem.law.multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  const ContactSolution<2> solution = solved(problem);
  RC_ASSERT(solution.status == ContactStatus::converged);
  const Estimate<2> estimate = estimated(problem, solution, tau, sweeps(4));
  RC_ASSERT(estimate.admissible);
  std::vector<SubcellStress<2>> of_u_hat;
  const LinearStresses<2> total = total_stresses(
      problem.mesh, solved_body(problem, solution, tau), estimate.displacement);
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    of_u_hat.push_back(subcell_values<2>(total.at_vertices(t)));
  const double of_stress = distance(exact.total, problem.mesh, estimate.stress),
               of_displacement = distance(exact.total, problem.mesh, of_u_hat);
  const double both = std::hypot(of_stress, of_displacement);
  RC_ASSERT(both <= estimate.e * (1 + 1e-10));
  RC_ASSERT(estimate.e <= 1.01 * both);
  RC_ASSERT(of_stress < of_displacement);
}

/// e, its local values and the scale are those of the fields, by either construction.
TEST(InitialStress, is_in_the_error_and_in_its_scale) {
  Random random(33);
  const Exact exact = exact_solution(0.3, random);
  Problem problem =
      loaded_in_contact(exact.total, irregular(4, 4, 2, 2, random));
  const LinearStresses<2> tau = at_vertices(problem.mesh, exact.tau);
  add_initial_stress(problem, tau);
  add_body_force(problem, exact.force);
  const ContactSolution<2> solution = solved(problem);
  const LinearStresses<2> total = total_stresses(
      problem.mesh, solved_body(problem, solution, tau), solution.displacement);
  double difference = 0, sum = 0;
  const Estimate<2> composite = estimated(problem, solution, tau);
  for (int t = 0; t < problem.mesh.cell_count(); ++t) {
    const CellCorners<2> corners = corners_of(problem.mesh, t);
    const Matrix3d compliance = problem.hooke[t].inverse();
    const SubcellStress<2> sigma = subcell_values<2>(total.at_vertices(t));
    difference += energy(corners, compliance, composite.stress[t] - sigma);
    sum += energy(corners, compliance, composite.stress[t] + sigma);
  }
  EXPECT_NEAR(composite.elastic / std::sqrt(difference), 1, 1e-10);
  EXPECT_NEAR(composite.relative * std::sqrt(sum) / composite.e, 1, 1e-10);
  EXPECT_NEAR(composite.local.norm() / composite.relative, 1, 1e-10);

  EstimateSettings<2> settings;
  settings.construction = Construction::polynomial;
  const Estimate<2> polynomial = estimated(problem, solution, tau, settings);
  EXPECT_LT(polynomial.e, composite.e);
  EXPECT_GT(polynomial.e, 0.8 * composite.e);
  const double scale = polynomial.e / polynomial.relative;
  EXPECT_NEAR(scale / std::sqrt(sum), 1, 1e-3);
}

TEST(InitialStress, that_does_not_fit_is_refused) {
  Problem problem = on_rollers(0);
  LinearStresses<2> tau = heated(problem.mesh);
  add_initial_stress(problem, tau);
  const ContactSolution<2> solution = solved(problem);
  const auto refusal_with = [&](const LinearStresses<2>& spoilt) {
    return refusal([&] { estimated(problem, solution, spoilt); });
  };
  EXPECT_TRUE(says(refusal_with({}), "do not balance the stresses at vertex"));
  LinearStresses<2> short_one = tau;
  short_one.mean.conservativeResize(3, 7);
  EXPECT_TRUE(says(refusal_with(short_one), "initial stress has 7 values"));
  tau.mean(1, 6) = std::nan("");
  EXPECT_TRUE(says(refusal_with(tau),
                   "the initial strain or stress on triangle 6 is not a finite "
                   "number"));
}

}  // namespace
}  // namespace ffcontact
