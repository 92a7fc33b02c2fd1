// SPDX-License-Identifier: GPL-3.0-or-later
// The bound with Coulomb's law, e / sqrt(1 - mu kappa), against nested reference
// solutions.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/bodies.hpp"
#include "support/coulomb.hpp"
#include "support/nested_reference.hpp"
#include "support/random.hpp"

namespace ffcontact::test {
namespace {

/// e, the bound and the true error of a solution, the latter against a problem whose mesh
/// is nested in its own.
struct Judged {
  double e, bound, error, mu_kappa;
  bool admissible;
};

Judged judged(const Problem& coarse, const Problem& fine) {
  const ContactSolution solution = solved(coarse), reference = solved(fine);
  const Estimate estimate = estimated(coarse, solution, sweeps(2));
  const SquaredDistances squares =
      squared_distances(coarse, estimate, fine, reference.displacement);
  const double mu = coarse.law.friction.maxCoeff(),
               kappa = kappa_of(coarse, solution);
  return {
      estimate.e, coulomb_bound(estimate.e, mu, kappa),
      std::sqrt(squares.stress + squares.displacement), mu * kappa,
      estimate.admissible && solution.accepted({}) && reference.accepted({})};
}

void print(const char* name, const Judged& j) {
  std::printf("| %s | %.3f | %.4e | %.4e | %.4e | %.2f |\n", name, j.mu_kappa,
              j.e, j.bound, j.error, j.bound / j.error);
}

/// Any mesh, any load, any coefficient: signs of slip are those that come.
RC_GTEST_PROP(coulomb_bound, holds_on_random_meshes_under_random_loads,
              (Random random)) {
  const Mesh mesh =
      irregular(*rc::gen::inRange(2, 6), *rc::gen::inRange(2, 5), 6, 4, random);
  const Vector2d on_left = random_vector(2, random) * 5,
                 on_right = random_vector(2, random) * 5;
  const double mu = *real(0.05, 1), nu = *real(0, 0.4);
  const Multiplier multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  const auto problem_on = [&](const Mesh& body_mesh) {
    Problem problem = body(body_mesh, material(1e3, nu));
    clamp(problem, top, [](const Vector2d&) { return Vector2d(1e-3, -1e-2); });
    add_traction(problem, left, on_left);
    add_traction(problem, right, on_right);
    set_friction(problem, mu);
    problem.law.multiplier = multiplier;
    return problem;
  };
  const Judged j = judged(problem_on(mesh), problem_on(subdivided(mesh, 3)));
  RC_ASSERT(j.admissible);
  RC_CLASSIFY(std::isfinite(j.bound), "bound");
  RC_CLASSIFY(j.error > (1 + 1e-6) * j.e, "e alone is none");
  RC_ASSERT(j.error <= j.bound);
}

/// Two bodies with matching traces or not, sheared.
RC_GTEST_PROP(coulomb_bound, holds_for_two_bodies, (Random random)) {
  const Mesh upper = shifted(
                 with_random_rows(*rc::gen::inRange(2, 5), 2, 5, 3, random),
                 {1, 4}),
             lower = with_random_rows(*rc::gen::inRange(3, 7), 2, 8, 4, random);
  const double mu = *real(0.05, 0.8), shear = *real(-4, 4);
  const Multiplier multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  const auto problem_on = [&](int times) {
    Bodies two = bodies({subdivided(upper, times), subdivided(lower, times)},
                        {material(70e3, 0.3), material(120e3, 0.2)},
                        {{0, bottom, 1, top}});
    Problem& problem = two.problem;
    add_traction(problem, two.label(0, top), {shear, -10});
    clamp(problem, two.label(1, bottom));
    prescribe(problem, two.label(0, right), 0);
    set_friction(problem, mu);
    problem.law.multiplier = multiplier;
    return problem;
  };
  const Judged j = judged(problem_on(0), problem_on(3));
  RC_ASSERT(j.admissible);
  RC_CLASSIFY(std::isfinite(j.bound), "bound");
  RC_CLASSIFY(j.error > (1 + 1e-6) * j.e, "e alone is none");
  RC_ASSERT(j.error <= j.bound);
}

}  // namespace
}  // namespace ffcontact::test
