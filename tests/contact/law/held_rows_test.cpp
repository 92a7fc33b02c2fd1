// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/held_rows.hpp"

#include <gtest/gtest.h>

#include "support/bodies.hpp"
#include "support/cases.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A block pressed on another and pushed from the side, both held by their left sides,
/// whose facing vertices miss each other by a part of an edge.
Bodies block_on_block(Multiplier multiplier, double apart) {
  const int n = 8;
  Mesh upper = shifted(rectangle(n, n, 80, 40), {0, 40}),
       lower = rectangle(n, n, 80, 40);
  for (int v = 0; v < lower.vertex_count(); ++v)
    if (lower.vertices(0, v) > 0 && lower.vertices(0, v) < 80)
      lower.vertices(0, v) += apart * 10;
  Bodies two =
      bodies({upper, lower}, {material(1000, 0.3), material(1500, 0.2)},
             {{0, bottom, 1, top}});
  Problem& problem = two.problem;
  for (int body : {0, 1}) prescribe(problem, two.label(body, left), 0);
  for (int body : {0, 1}) prescribe(problem, two.label(body, left), 1);
  prescribe(problem, two.label(1, bottom), 1);
  add_traction(problem, two.label(0, top), {2, -5});
  set_friction(problem, 0.4);
  problem.law.multiplier = multiplier;
  return two;
}

TEST(HeldRows, are_those_that_no_free_dof_moves) {
  for (double apart : {0.0, 1e-9, 1e-7, 1e-5, 1e-4}) {
    const Bodies two = block_on_block(Multiplier::force, apart);
    const ContactLine& line = two.problem.line;
    const std::vector<char> held =
        held_rows(line, two.problem.system().prescribed);
    for (int i = 0; i < line.node_count(); ++i) {
      const bool at_left = two.joined.mesh.vertices(0, line.vertex[i]) +
                               two.joined.mesh.origin.x() <
                           1e-9;
      EXPECT_EQ(held[2 * i], at_left) << apart << " " << i;
      EXPECT_EQ(held[2 * i + 1], at_left) << apart << " " << i;
    }
  }
}

TEST(HeldRows, vertices_that_all_but_meet_change_answers_as_little) {
  for (Multiplier multiplier : both_multipliers) {
    const ContactSolution<2> met =
        solved(block_on_block(multiplier, 0).problem);
    for (double apart : {1e-7, 1e-6, 1e-5, 1e-4}) {
      const ContactSolution<2> near =
          solved(block_on_block(multiplier, apart).problem);
      ASSERT_EQ(near.status, ContactStatus::converged);
      EXPECT_LT((near.displacement - met.displacement).cwiseAbs().maxCoeff(),
                10 * apart * met.displacement.cwiseAbs().maxCoeff());
      EXPECT_LT((near.force - met.force).cwiseAbs().maxCoeff(),
                10 * apart * met.force.cwiseAbs().maxCoeff())
          << near.force << "\n\n"
          << met.force;
    }
  }
}

TEST(HeldRows, carry_no_force_and_move_as_prescribed) {
  const Bodies two = block_on_block(Multiplier::force, 1e-5);
  const auto& [line, law] = std::tie(two.problem.line, two.problem.law);
  const ElasticSystem system = two.problem.system();
  const HeldRows<2> held = held_rows(line, law, system);
  const VectorXd u = VectorXd::LinSpaced(system.dof_count(), -1, 2);
  const Matrix2Xd v = steered_displacement(line, law, held, u),
                  free = displacement_against_foundation(line, law, u),
                  F = without<Matrix2Xd>(held.row,
                                         Matrix2Xd::Ones(2, line.node_count()));
  for (Index row = 0; row < v.size(); ++row) {
    EXPECT_EQ(F.reshaped()[row], held.row[row] ? 0 : 1);
    EXPECT_EQ(v.reshaped()[row], held.row[row] ? 0 : free.reshaped()[row]);
  }
}

}  // namespace
}  // namespace ffcontact
