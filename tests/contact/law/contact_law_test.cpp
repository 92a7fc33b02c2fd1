// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/contact_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "ffcontact/contact/law/nodal_law.hpp"
#include "support/cases.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A solved block with open, sticking and slipping nodes: benchmark B1.
struct Solved {
  Problem problem;
  ContactSolution solution;
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
  const auto& [line, law] = std::tie(s.problem.line, s.problem.law);
  const HeldRows held = held_rows(line, law, s.problem.system());
  return complementarity_defect(line, law, held, u, P);
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

std::string refusal_of(const ContactLaw& law, const ContactLine& line) {
  return refusal([&] { require_valid(law, line); });
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

TEST(ContactLaw, weight_is_the_mass_for_pressures_and_one_for_forces) {
  const ContactLine line = example_1(Multiplier::force, 2).line;
  EXPECT_EQ(MatrixXd(weight_matrix(Multiplier::pressure, line)),
            MatrixXd(contact_mass(line)));
  EXPECT_EQ(MatrixXd(weight_matrix(Multiplier::force, line)),
            MatrixXd::Identity(5, 5));
}

RC_GTEST_PROP(ContactLaw,
              weighted_multipliers_are_the_load_of_the_vector_density,
              (Random random)) {
  Mesh mesh = irregular(4, 3, 4, 3, random);
  for (int v = 0; v < mesh.vertex_count(); ++v)
    mesh.vertices(1, v) -=
        0.1 * mesh.vertices(0, v) * (4 - mesh.vertices(0, v));
  const ContactLine line = contact_line(mesh, edges_of(mesh), {bottom, left});
  const VectorXd P = random_vector(2 * line.node_count(), random);
  const auto vector_at = [&](int i) -> Vector2d {
    return P[2 * i] * line.normal.col(i) + P[2 * i + 1] * line.tangent(i);
  };
  Matrix2Xd load =
      // int (sum of P_j psi_j) psi_i, vector by vector
      Matrix2Xd::Zero(2, line.node_count());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        load.col(line.edge_node(a, e)) +=
            line.length[e] / (a == b ? 3 : 6) * vector_at(line.edge_node(b, e));
  const VectorXd weighted = weight_of_rows(Multiplier::pressure, line) * P;
  for (int i = 0; i < line.node_count(); ++i) {
    const Vector2d force = weighted[2 * i] * line.normal.col(i) +
                           weighted[2 * i + 1] * line.tangent(i);
    RC_ASSERT((force - load.col(i)).norm() < 1e-13);
  }
}

TEST(ContactLaw, gap_and_previous_displacement_are_taken_off) {
  const Problem problem = example_1(Multiplier::force, 2);
  ContactLaw law = problem.law;
  law.gap = VectorXd::LinSpaced(5, 0, 4);
  law.previous = everywhere(problem.line, 0.5);
  const VectorXd u = nodal_values(
      problem.mesh, [](const Vector2d&) { return Vector2d(2, -3); });
  const Matrix2Xd against =
      displacement_against_foundation(problem.line, law, u);
  // n = (0, -1), t = (1, 0)
  for (int i = 0; i < 5; ++i) EXPECT_EQ(against.col(i), Vector2d(3 - i, 1.5));
}

TEST(ContactLaw, slip_sign_is_the_sign_of_the_motion_along_t) {
  EXPECT_EQ(slip_sign(ContactState::slip_forward), 1);
  EXPECT_EQ(slip_sign(ContactState::slip_backward), -1);
  EXPECT_EQ(slip_sign(ContactState::stick), 0);
  EXPECT_EQ(slip_sign(ContactState::open), 0);
}

TEST(ContactLaw, refuses_friction_that_is_negative_or_not_a_number) {
  const Problem problem = example_1(Multiplier::force, 2);
  ContactLaw law = problem.law;
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
  ContactLaw law = problem.law;
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

}  // namespace
}  // namespace ffcontact
