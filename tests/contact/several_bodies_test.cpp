// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "support/bodies.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Uniform compression by the pressure p between supports that let the bodies expand.
void press(Bodies& stack, double p) {
  Problem& problem = stack.problem;
  const int last = stack.joined.body_count() - 1;
  add_traction(problem, stack.label(0, top), {0, -p});
  prescribe(problem, stack.label(last, bottom), 1);
  for (int k = 0; k <= last; ++k) prescribe(problem, stack.label(k, left), 0);
}

/// Largest deviation of the pressures from p and of the stresses from (0, -p, 0),
/// relative to p.
double patch_defect(const Bodies& stack, const ContactSolution<2>& solution,
                    double p) {
  const Problem& problem = stack.problem;
  const Matrix3Xd stress =
      stresses(problem.mesh, problem.hooke, solution.displacement);
  double defect = (stress.colwise() - Vector3d(0, -p, 0)).cwiseAbs().maxCoeff();
  defect =
      std::max(defect, (solution.pressure.row(0).array() + p).abs().maxCoeff());
  return std::max(defect, solution.pressure.row(1).cwiseAbs().maxCoeff()) / p;
}

double patch_defect(const Mesh& upper, const Mesh& lower,
                    Multiplier multiplier) {
  Bodies stack =
      bodies({upper, lower}, {material(70e3, 0.3), material(210e3, 0.2)},
             {{0, bottom, 1, top}});
  press(stack, 7);
  stack.problem.law.multiplier = multiplier;
  const ContactSolution<2> solution = solved(stack.problem);
  EXPECT_TRUE(solution.accepted({}))
      << in_words(solution.status) << " " << solution.complementarity << " "
      << solution.residual;
  return patch_defect(stack, solution, 7);
}

TEST(SeveralBodies,
     uniform_pressure_passes_through_interfaces_that_do_not_match) {
  for (const Multiplier multiplier : both_multipliers)
    for (const auto& [upper, lower] :
         {std::pair(2, 3), std::pair(3, 2), std::pair(7, 11), std::pair(11, 7)})
      EXPECT_LT(patch_defect(shifted(rectangle(upper, 2, 6, 4), {0, 5}),
                             rectangle(lower, 3, 6, 5), multiplier),
                1e-10)
          << upper << " : " << lower;
}

RC_GTEST_PROP(SeveralBodies, uniform_pressure_passes_through_random_nodes,
              (Random random)) {
  const int upper = *rc::gen::inRange(1, 9), lower = *rc::gen::inRange(1, 9);
  const Multiplier multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  RC_ASSERT(patch_defect(
                shifted(with_random_rows(upper, 3, 6, 4, random), {0, 5}),
                with_random_rows(lower, 3, 6, 5, random), multiplier) < 1e-10);
}

TEST(SeveralBodies, stack_of_three_passes_uniform_pressure) {
  Bodies stack =
      bodies({shifted(rectangle(5, 2, 6, 2), {0, 5}),
              shifted(rectangle(3, 2, 6, 3), {0, 2}), rectangle(4, 2, 6, 2)},
             {material(70e3, 0.3), material(3e3, 0.4), material(210e3, 0.2)},
             {{0, bottom, 1, top}, {1, bottom, 2, top}});
  press(stack, 3);
  const ContactSolution<2> solution = solved(stack.problem);
  ASSERT_TRUE(solution.accepted({}));
  EXPECT_LT(patch_defect(stack, solution, 3), 1e-10);
}

/// Loads and contact forces balance on each body: their sum over its vertices, supports
/// excepted.
TEST(SeveralBodies, example_3_carries_its_load_through_contact) {
  for (const Multiplier multiplier : both_multipliers) {
    const Bodies two = example_3(multiplier);
    const ContactSolution<2> solution = solved(two.problem);
    ASSERT_TRUE(solution.accepted({})) << in_words(solution.status);
    EXPECT_TRUE(two.problem.line.matches());
    EXPECT_NEAR(solution.force.row(0).sum(), -1000, 1e-9);
    EXPECT_NEAR(solution.force.row(1).sum(), 0, 1e-9);
  }
}

/// Which of two matching traces carries the multipliers makes no difference.
TEST(SeveralBodies, matching_bodies_can_be_exchanged) {
  for (const Multiplier multiplier : both_multipliers) {
    const auto problem = [&](bool exchanged) {
      const Mesh upper = shifted(rectangle(6, 3, 6, 3), {0, 4}),
                 lower = rectangle(6, 4, 6, 4);
      Bodies two = bodies(
          {upper, lower}, {material(70e3, 0.3), material(210e3, 0.2)},
          {exchanged ? Pair{1, top, 0, bottom} : Pair{0, bottom, 1, top}});
      add_traction(two.problem, two.label(0, top), {2, -10});
      add_traction(two.problem, two.label(0, left), {3, 0});
      clamp(two.problem, two.label(1, bottom));
      set_friction(two.problem, 0.4);
      two.problem.law.multiplier = multiplier;
      return two.problem;
    };
    const ContactSolution<2> one = solved(problem(false)),
                             other = solved(problem(true));
    ASSERT_TRUE(one.accepted({}) && other.accepted({}));
    EXPECT_LT(relative_difference(one.displacement, other.displacement), 1e-10);
    EXPECT_LT(relative_difference(one.pressure.row(0),
                                  other.pressure.row(0).reverse()),
              1e-9);
  }
}

/// A stiff lower body is a rigid foundation.
TEST(SeveralBodies, very_stiff_opposite_body_is_a_rigid_foundation) {
  const auto load = [](Problem& problem, int label_top, int label_left) {
    add_traction(problem, label_top, {0, -10});
    add_traction(problem, label_left, {2, 0});
    set_friction(problem, 0.3);
  };
  Bodies two = bodies(
      {rectangle(8, 4, 8, 4), shifted(rectangle(11, 3, 10, 2), {-1, -2})},
      {material(1e3, 0.3), material(1e13, 0.3)}, {{0, bottom, 1, top}});
  load(two.problem, two.label(0, top), two.label(0, left));
  clamp(two.problem, two.label(1, bottom));
  Problem one = body(rectangle(8, 4, 8, 4), material(1e3, 0.3));
  load(one, top, left);
  for (const Multiplier multiplier : both_multipliers) {
    two.problem.law.multiplier = one.law.multiplier = multiplier;
    const ContactSolution<2> on_body = solved(two.problem),
                             on_foundation = solved(one);
    EXPECT_LT(relative_difference(on_body.pressure, on_foundation.pressure),
              1e-6);
  }
}

TEST(SeveralBodies, gaps_are_read_from_the_meshes) {
  const Bodies two =
      bodies({shifted(rectangle(4, 2, 4, 2), {0, 0.25}),
              shifted(rectangle(5, 2, 4, 2), {0, -2})},
             {material(1, 0.3), material(1, 0.3)}, {{0, bottom, 1, top}});
  EXPECT_LT((two.traces[0].gap.array() - 0.25).abs().maxCoeff(), 1e-14);
}

TEST(SeveralBodies,
     refuses_a_line_that_faces_nothing_and_bodies_nothing_holds) {
  const std::string beyond = refusal([] {
    bodies({shifted(rectangle(4, 2, 4, 2), {5, 2}), rectangle(5, 2, 4, 2)},
           {material(1, 0.3), material(1, 0.3)}, {{0, bottom, 1, top}});
  });
  EXPECT_TRUE(says(beyond, "no point of the contact line")) << beyond;
  Bodies two =
      bodies({shifted(rectangle(4, 2, 4, 2), {0, 2}), rectangle(5, 2, 4, 2)},
             {material(1, 0.3), material(1, 0.3)}, {{0, bottom, 1, top}});
  add_traction(two.problem, two.label(0, top), {0, -1});
  const std::string unheld = refusal([&] { solved(two.problem); });
  EXPECT_TRUE(says(unheld,
                   "no equilibrium: the loads push the body about (2, 3) in a "
                   "translation along (0, -1), which neither"))
      << unheld;
}

}  // namespace
}  // namespace ffcontact
