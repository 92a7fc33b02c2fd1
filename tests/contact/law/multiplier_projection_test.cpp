// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/multiplier_projection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "support/cases.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// From pressures to the multipliers of the law: p for M'_h, F_i = len_i p_i for M''_h.
VectorXd weight_to_multiplier(const Problem& problem) {
  const bool forces = problem.law.multiplier == Multiplier::force;
  return forces ? nodal_lengths(problem.line) : everywhere(problem.line, 1);
}

Matrix2Xd multipliers(const Problem& problem, const Matrix2Xd& pressure) {
  return pressure * weight_to_multiplier(problem).asDiagonal();
}

Problem random_line(Random& random) {
  Problem problem = body(irregular(4, 2, 4, 2, random), material(1, 0));
  set_friction(problem, *real(0, 1));
  problem.law.multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  return problem;
}

RC_GTEST_PROP(MultiplierProjection, is_in_the_law_and_leaves_what_is_in_it,
              (Random random)) {
  const Problem problem = random_line(random);
  const Matrix2Xd pressure =
      random_matrix(2, problem.line.node_count(), random);
  const MultiplierProjection once =
      projected_multipliers(problem.line, problem.law, pressure);
  const Matrix2Xd P = multipliers(problem, once.pressure);
  for (int i = 0; i < problem.line.node_count(); ++i) {
    RC_ASSERT(P(0, i) <= 1e-13);
    RC_ASSERT(std::abs(P(1, i)) <= -problem.law.friction[i] * P(0, i) + 1e-13);
  }
  const MultiplierProjection twice =
      projected_multipliers(problem.line, problem.law, once.pressure);
  RC_ASSERT((twice.pressure - once.pressure).cwiseAbs().maxCoeff() < 1e-12);
}

RC_GTEST_PROP(MultiplierProjection,
              with_given_slip_limit_is_the_nearest_multiplier,
              (Random random)) {
  const Problem problem = random_line(random);
  const int nodes = problem.line.node_count();
  const Matrix2Xd pressure = random_matrix(2, nodes, random);
  const VectorXd given = -random_vector(nodes, random).cwiseAbs();
  const VectorXd limit = weight_to_multiplier(problem).cwiseProduct(given),
                 bound = -problem.law.friction.cwiseProduct(limit);
  const Matrix2Xd P = multipliers(problem, pressure);
  const Matrix2Xd projected = multipliers(
      problem, projected_multipliers(problem.line, problem.law, pressure, given)
                   .pressure);
  for (int i = 0; i < nodes; ++i) {
    RC_ASSERT(std::abs(projected(0, i) - std::min(P(0, i), 0.0)) < 1e-12);
    RC_ASSERT(std::abs(projected(1, i) -
                       std::clamp(P(1, i), -bound[i], bound[i])) < 1e-12);
  }
}

RC_GTEST_PROP(MultiplierProjection, of_a_solution_changes_nothing, ()) {
  Case c = *random_case(0.5);
  c.support = Support::clamped_top;
  const Problem problem = problem_of(c);
  const ContactSolution<2> solution = solved(problem);
  const Matrix2Xd pressure =
      problem.law.multiplier == Multiplier::pressure
          ? solution.pressure
          : lumped_pressures(problem.line, solution.force);
  const MultiplierProjection projection =
      projected_multipliers(problem.line, problem.law, pressure);
  RC_ASSERT((projection.pressure - pressure).cwiseAbs().maxCoeff() < 1e-10);
}

TEST(MultiplierProjection, refuses_what_does_not_fit) {
  const Problem problem = example_1(Multiplier::force, 2);
  const auto refusal_of = [&](const Matrix2Xd& pressure,
                              const VectorXd& given) {
    return refusal([&] {
      projected_multipliers(problem.line, problem.law, pressure, given);
    });
  };
  EXPECT_NE(refusal_of(Matrix2Xd::Zero(2, 4), {}), "accepted");
  EXPECT_NE(refusal_of(Matrix2Xd::Constant(2, 5, std::nan("")), {}),
            "accepted");
  EXPECT_NE(refusal_of(Matrix2Xd::Zero(2, 5), VectorXd::Zero(3)), "accepted");
  EXPECT_EQ(refusal_of(Matrix2Xd::Zero(2, 5), VectorXd::Zero(5)), "accepted");
}

}  // namespace
}  // namespace ffcontact
