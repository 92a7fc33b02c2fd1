// SPDX-License-Identifier: GPL-3.0-or-later
// The bounds (2.20), for Tresca's law and without friction, and (2.14) for Coulomb's law,
// against nested reference solutions.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/nested_reference.hpp"
#include "support/random.hpp"

namespace ffcontact::test {
namespace {

constexpr int nx = 8, ny = 4, finer = 16;

/// 2 mu int (r_n - r_hat_n)(|w_hat_t| - |w_t|) with r, w of the reference: the term of
/// (2.14) without a sign.
double coulomb_term(const Problem& coarse, const Estimate<2>& estimate,
                    const Problem& fine, const ContactSolution<2>& reference) {
  const Matrix2Xd w = contact_components(fine.line, reference.displacement);
  const Matrix2Xd w_hat =
      contact_components(coarse.line, estimate.displacement);
  double sum = 0;
  for (int e = 0; e < fine.line.edge_count(); ++e) {
    const int E = e / finer;
    const double x = (e % finer + 0.5) / finer;
    const auto linear = [&](double first, double second) {
      return (1 - x) * first + x * second;
    };
    const int i = fine.line.edge_node(0, e), j = fine.line.edge_node(1, e);
    const int I = coarse.line.edge_node(0, E), J = coarse.line.edge_node(1, E);
    const double r =
        0.5 * (reference.pressure(0, i) + reference.pressure(0, j));
    const double r_hat = linear(estimate.tractions.normal(0, E),
                                estimate.tractions.normal(1, E));
    const double slip = 0.5 * (std::abs(w(1, i)) + std::abs(w(1, j))),
                 slip_hat = std::abs(linear(w_hat(1, I), w_hat(1, J)));
    sum += 2 * coarse.law.friction[I] * fine.line.length[e] * (r - r_hat) *
           (slip_hat - slip);
  }
  return sum;
}

struct Law {
  double friction, slip_bound;
  Multiplier multiplier;
};

Problem pressed(int ratio, const Law& law, unsigned seed) {
  std::mt19937 random(seed);
  const Uniform push{-3, 12}, press{2, 15};
  Problem problem =
      body(rectangle(nx * ratio, ny * ratio, 80, 40), material(13e3, 0.2));
  clamp(problem, top, [](const Vector2d&) { return Vector2d(0, -2e-3); });
  const double lateral = push(random);
  add_traction(problem, left, {lateral, 0});
  add_traction(problem, right, {-press(random), -press(random) / 4});
  problem.law.multiplier = law.multiplier;
  set_friction(problem, law.friction);
  if (law.slip_bound > 0)
    problem.law.slip_bound = everywhere(problem.line, law.slip_bound);
  return problem;
}

struct Bound {
  double e_square, stress_square, displacement_square, term;
};

Bound bound(const Law& law, unsigned seed) {
  const Problem coarse = pressed(1, law, seed),
                fine = pressed(finer, law, seed);
  const ContactSolution<2> solution = solved(coarse), reference = solved(fine);
  EXPECT_EQ(solution.status, ContactStatus::converged);
  EXPECT_EQ(reference.status, ContactStatus::converged);
  const Estimate<2> estimate = estimated(coarse, solution, sweeps(2));
  EXPECT_TRUE(estimate.admissible) << estimate.reason;
  const SquaredDistances squares =
      squared_distances(coarse, estimate, fine, reference.displacement);
  return {estimate.e * estimate.e, squares.stress, squares.displacement,
          coulomb_term(coarse, estimate, fine, reference)};
}

TEST(bound, holds_for_tresca_and_without_friction) {
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (const Law& law :
         {Law{0, 0, Multiplier::force}, Law{0, 0, Multiplier::pressure},
          Law{0, 1.5, Multiplier::force}, Law{0, 1.5, Multiplier::pressure}}) {
      const Bound b = bound(law, seed);
      std::printf("k %.1f seed %u: %.4e + %.4e <= %.4e\n", law.slip_bound, seed,
                  b.stress_square, b.displacement_square, b.e_square);
      EXPECT_LE(b.stress_square + b.displacement_square, b.e_square);
    }
}

/// Any mesh and any load: the reference is on the same mesh with every triangle cut into
/// 64.
RC_GTEST_PROP(bound, holds_on_random_meshes_under_random_loads,
              (Random random)) {
  const RandomBlock block = random_block(random);
  const double slip_bound = *rc::gen::element(0.0, 0.5, 2.0);
  const auto problem_on = [&](const Mesh& body_mesh) {
    Problem problem = block.on(body_mesh);
    if (slip_bound > 0)
      problem.law.slip_bound = everywhere(problem.line, slip_bound);
    return problem;
  };
  const Problem coarse = problem_on(block.mesh);
  Problem fine = problem_on(subdivided(block.mesh, 3));
  fine.law.multiplier = Multiplier::force;
  const ContactSolution<2> solution = solved(coarse), reference = solved(fine);
  RC_ASSERT(solution.accepted({}) && reference.accepted({}));
  const Estimate<2> estimate = estimated(coarse, solution, sweeps(2));
  RC_ASSERT(estimate.admissible);
  const BoundByReference found =
      bound_by_reference(coarse, estimate, fine, reference.displacement);
  // without friction, and where all contact is open or closed, both sides are equal
  constexpr double rounding = 1e-10;
  RC_ASSERT(found.errors <= (1 + rounding) * found.bound);
}

TEST(bound, terms_for_coulomb) {
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (Multiplier multiplier : {Multiplier::force, Multiplier::pressure}) {
      const Bound b = bound({0.4, 0, multiplier}, seed);
      std::printf("mu 0.4 seed %u: %.4e + %.4e %+.4e (integral term) <= %.4e\n",
                  seed, b.stress_square, b.displacement_square, b.term,
                  b.e_square);
      EXPECT_LE(b.stress_square + b.displacement_square + b.term, b.e_square);
    }
}

}  // namespace
}  // namespace ffcontact::test
