// SPDX-License-Identifier: GPL-3.0-or-later
// The bound with Coulomb's law, e / sqrt(1 - mu kappa), against nested reference
// solutions.
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>

#include "support/bodies.hpp"
#include "support/coulomb.hpp"
#include "support/nested_reference.hpp"
#include "support/random.hpp"

namespace ffcontact::test {
namespace {

/// e, kappa, and the true error against a problem whose mesh is nested in its own.
struct Judged {
  double e, error, friction, critical;
  double kappa, kappa_held;  ///< sticking nodes free to slip, or held
  bool admissible;

  double bound() const { return coulomb_bound(e, friction, kappa); }
  double bound_held() const { return coulomb_bound(e, friction, kappa_held); }
};

Judged judged(const Problem& coarse, const Problem& fine) {
  const ContactSolution<2> solution = solved(coarse), reference = solved(fine);
  const Estimate<2> estimate = estimated(coarse, solution, sweeps(2));
  const SquaredDistances squares =
      squared_distances(coarse, estimate, fine, reference.displacement);
  return {
      estimate.e,
      std::sqrt(squares.stress + squares.displacement),
      coarse.law.friction.maxCoeff(),
      critical_friction_of(coarse, solution),
      kappa_of(coarse, solution),
      kappa_of(coarse, solution, StuckNodes::stick),
      estimate.admissible && solution.accepted({}) && reference.accepted({})};
}

/// Where all that touches sticks, both sides of the bound are equal.
constexpr double rounding = 1e-10;

/// The published problems on the published meshes; prints the table of tests/validation.md.
struct Published {
  const char* name;
  double friction;
  std::function<Problem(int ratio)> problem;
};

std::vector<Published> published() {
  constexpr Multiplier force = Multiplier::force;
  std::vector<Published> problems{
      {"example 1", 0.5,
       [](int ratio) { return example_1(force, 16 * ratio); }},
      {"example 2", 0.3,
       [](int ratio) { return example_2(force, 0.3, 16 * ratio); }},
      {"example 3", 0.3, [](int ratio) {
         return example_3(force, 8 * ratio, 16 * ratio).problem;
       }}};
  for (const double mu : {0.2, 0.4, 0.6, 0.8})
    problems.push_back({"table 1", mu, [mu](int ratio) {
                          return example_2(force, mu, 16 * ratio);
                        }});
  return problems;
}

TEST(coulomb_bound, of_the_published_problems) {
  constexpr int finer = 8;
  for (const auto& [name, mu, problem] : published()) {
    const Judged j = judged(problem(1), problem(finer));
    std::printf(
        "| %s | %.1f | %.4f | %.3f | %.3f | %.4f | %.2f | %.3f | %.4f | %.2f "
        "| %.2f | %.2f |\n",
        name, mu, j.error, j.e / j.error, j.kappa, j.bound(),
        j.bound() / j.error, j.kappa_held, j.bound_held(),
        j.bound_held() / j.error, 1 / j.kappa_held, j.critical);
    EXPECT_TRUE(j.admissible);
    EXPECT_GE((1 + rounding) * j.bound(), j.error);
    EXPECT_GE((1 + rounding) * j.bound_held(), j.error);
    EXPECT_GE(j.critical, (1 - rounding) / j.kappa_held);
  }
}

/// Any mesh, any load, any coefficient, also one that varies or with a shear limit: signs
/// of slip are those that come.
RC_GTEST_PROP(coulomb_bound, holds_on_random_meshes_under_random_loads,
              (Random random)) {
  const RandomBlock block = random_block(random);
  const double mu = *real(0.05, 1), slope = *rc::gen::element(0.0, -0.15, 0.1),
               limit = *rc::gen::element(0.0, 0.0, 0.5);
  const auto problem_on = [&](const Mesh& body_mesh) {
    Problem problem = block.on(body_mesh);
    for (int i = 0; i < problem.line.node_count(); ++i)
      problem.law.friction[i] =
          mu * (1 + slope * problem.mesh.vertices(0, problem.line.vertex[i]));
    if (limit > 0) problem.law.shear_limit = everywhere(problem.line, limit);
    return problem;
  };
  const Judged j =
      judged(problem_on(block.mesh), problem_on(subdivided(block.mesh, 3)));
  RC_ASSERT(j.admissible);
  RC_CLASSIFY(std::isfinite(j.bound()), "bound");
  RC_CLASSIFY(j.error > (1 + 1e-6) * j.e, "e alone is none");
  RC_ASSERT(j.error <= (1 + rounding) * j.bound());
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
  RC_CLASSIFY(std::isfinite(j.bound()), "bound");
  RC_CLASSIFY(j.error > (1 + 1e-6) * j.e, "e alone is none");
  RC_ASSERT(j.error <= (1 + rounding) * j.bound());
}

}  // namespace
}  // namespace ffcontact::test
