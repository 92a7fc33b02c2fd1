// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/stated_contact.hpp"

#include <gtest/gtest.h>

#include "support/cases.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A solved block with open, sticking and slipping nodes: benchmark B1.
struct Solved {
  Problem problem;
  ContactSolution<2> solution;
};
Solved three_zones(Multiplier multiplier) {
  Problem problem = block_with_three_zones(16);
  problem.law.multiplier = multiplier;
  return {problem, solved(problem)};
}

const Matrix2Xd& multiplier_of(const Solved& s) {
  return s.problem.law.multiplier == Multiplier::force ? s.solution.force
                                                       : s.solution.pressure;
}

double defect(const Solved& s, const VectorXd& u, const Matrix2Xd& P) {
  const ElasticSystem system = s.problem.system();
  return stated_on_line(s.problem.line, s.problem.law, system, {})
      .law_defect(u, P.reshaped());
}

/// The defect when one number of the multipliers is changed by a part of the largest.
double spoiled_multiplier(const Solved& s, int component, int node,
                          double part) {
  Matrix2Xd P = multiplier_of(s);
  P(component, node) += part * P.cwiseAbs().maxCoeff();
  return defect(s, s.solution.displacement, P);
}

/// The defect when a component of u at one contact node is changed by a part of the
/// largest displacement.
double spoiled_displacement(const Solved& s, int component, int node,
                            double part) {
  VectorXd u = s.solution.displacement;
  const Vector2d direction = component == 0
                                 ? Vector2d(s.problem.line.normal.col(node))
                                 : s.problem.line.tangent(node);
  u.segment<2>(2 * s.problem.line.vertex[node]) +=
      part * u.cwiseAbs().maxCoeff() * direction;
  return defect(s, u, multiplier_of(s));
}

int first_node(const Solved& s, bool (*wanted)(ContactState)) {
  const auto& state = s.solution.state;
  return static_cast<int>(std::find_if(state.begin(), state.end(), wanted) -
                          state.begin());
}
int open_node(const Solved& s) {
  return first_node(
      s, [](ContactState state) { return state == ContactState::open; });
}
int sticking_node(const Solved& s) {
  return first_node(
      s, [](ContactState state) { return state == ContactState::stick; });
}
int slipping_node(const Solved& s) {
  return first_node(s,
                    [](ContactState state) { return slip_sign(state) != 0; });
}

class Complementarity : public testing::TestWithParam<Multiplier> {};
INSTANTIATE_TEST_SUITE_P(Law, Complementarity,
                         testing::Values(Multiplier::force,
                                         Multiplier::pressure),
                         [](const auto& info) {
                           return info.param == Multiplier::force ? "force"
                                                                  : "pressure";
                         });

TEST_P(Complementarity, holds_at_a_solution) {
  const Solved s = three_zones(GetParam());
  EXPECT_LE(defect(s, s.solution.displacement, multiplier_of(s)), 1e-10);
}

TEST_P(Complementarity, fails_when_an_open_node_is_pressed_or_pulled) {
  const Solved s = three_zones(GetParam());
  EXPECT_GT(spoiled_multiplier(s, 0, open_node(s), 1e-4), 0.9e-4);  // P_n > 0
  EXPECT_GT(spoiled_multiplier(s, 0, open_node(s), -1e-2),
            1e-8);  // P_n v_n != 0
  EXPECT_GT(spoiled_multiplier(s, 1, open_node(s), 1e-4),
            0.9e-4);  // |P_t| > -mu P_n = 0
}

TEST_P(Complementarity, fails_when_a_closed_node_penetrates_or_opens) {
  const Solved s = three_zones(GetParam());
  EXPECT_GT(spoiled_displacement(s, 0, sticking_node(s) + 1, 1e-4), 1e-5);
  EXPECT_GT(spoiled_displacement(s, 0, sticking_node(s) + 1, -1e-4), 1e-6);
}

TEST_P(Complementarity,
       fails_when_a_sticking_node_moves_or_is_pulled_out_of_the_cone) {
  const Solved s = three_zones(GetParam());
  EXPECT_GT(spoiled_displacement(s, 1, sticking_node(s) + 1, 1e-4), 1e-5);
  EXPECT_GT(spoiled_multiplier(s, 1, sticking_node(s) + 1, 10), 0.5);
}

TEST_P(Complementarity,
       fails_when_a_slipping_node_is_not_at_the_bound_or_is_pushed_along) {
  const Solved s = three_zones(GetParam());
  const int node = slipping_node(s);
  // |P_t| < -mu P_n while v_t != 0
  EXPECT_GT(spoiled_multiplier(s, 1, node, 1e-4), 1e-6);
  EXPECT_GT(spoiled_multiplier(s, 1, node, -1e-4), 0.9e-4);
  Matrix2Xd P = multiplier_of(s);
  P(1, node) *= -1;
  EXPECT_GT(defect(s, s.solution.displacement, P), 1e-4);
}

}  // namespace
}  // namespace ffcontact
