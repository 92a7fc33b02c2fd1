// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <functional>

#include "ffcontact/bounds/coulomb_on_line.hpp"
#include "support/bodies.hpp"
#include "support/bounded.hpp"
#include "support/coulomb.hpp"
#include "support/nested_reference.hpp"
#include "support/quantities.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

QuantityBounds bounds_of(const Problem& problem, const Quantity<2>& quantity) {
  const Solved solved(problem);
  BoundSettings settings;
  settings.friction_share = problem.law.friction.maxCoeff() * kappa_of(problem);
  return solved.bounds(quantity, settings);
}

Problem rubbed_example_1(double mu, int cells) {
  Problem problem = example_1(Multiplier::force, cells);
  set_friction(problem, mu);
  return problem;
}

QuantityBounds of_the_left_side(const Problem& problem) {
  return bounds_of(problem, on_label<2>(problem.mesh, left, {1.0 / 40, 0}));
}

/// Values extrapolated from meshes of up to 128 cells, widths in % of them.
TEST(CoulombBounds, have_known_values_between_them_and_are_known_to_be_near) {
  struct Known {
    double mu, exact, wide_with_8, wide_with_16;
  };
  for (const Known& known :
       {Known{0.2, 0.02507, 7.8, 3.2}, Known{0.5, 0.02351, 24, 10.7}})
    for (const int cells : {8, 16}) {
      const QuantityBounds found =
          of_the_left_side(rubbed_example_1(known.mu, cells));
      EXPECT_LT(found.lower, known.exact);
      EXPECT_GT(found.upper, known.exact);
      const double wide = cells == 8 ? known.wide_with_8 : known.wide_with_16;
      EXPECT_LT(found.width(), wide / 100 * known.exact);
    }
}

TEST(CoulombBounds, are_those_without_friction_as_it_vanishes) {
  const QuantityBounds rubbed = of_the_left_side(rubbed_example_1(1e-9, 8)),
                       smooth = of_the_left_side(rubbed_example_1(0, 8));
  EXPECT_NEAR(rubbed.lower, smooth.lower, 1e-3 * smooth.width());
  EXPECT_NEAR(rubbed.upper, smooth.upper, 1e-3 * smooth.width());
}

TEST(CoulombBounds, are_none_where_mu_kappa_is_not_below_1) {
  const QuantityBounds found = of_the_left_side(rubbed_example_1(0.8, 8));
  EXPECT_FALSE(found.found());
  EXPECT_EQ(found.reason.substr(0, 13), "mu kappa is 1");
}

/// Stresses that are better without Coulomb's terms may be worse with them.
TEST(CoulombBounds, are_not_widened_by_further_turns) {
  const Problem problem = rubbed_example_1(0.5, 8);
  const Solved solved(problem);
  BoundSettings settings;
  settings.friction_share = 0.5 * kappa_of(problem);
  settings.turns = 2;
  settings.relaxation.steps = 1;
  QuantityBounds last;
  for (int k = 0; k < 4; ++k) {
    settings.further_turns = k;
    const QuantityBounds next =
        solved.bounds(on_label<2>(problem.mesh, left, {1.0 / 40, 0}), settings);
    EXPECT_GE(next.lower, last.lower);
    EXPECT_LE(next.upper, last.upper);
    last = next;
  }
}

TEST(CoulombBounds, are_wider_with_a_larger_constant) {
  const Problem problem = rubbed_example_1(0.2, 8);
  const Solved solved(problem);
  const auto width = [&](double share) {
    BoundSettings settings;
    settings.friction_share = share;
    return solved
        .bounds(on_label<2>(problem.mesh, left, {1.0 / 40, 0}), settings)
        .width();
  };
  EXPECT_GT(width(0.6), 1.2 * width(0.3));
}

/// v = u_hat is on the boundary of the conditions where u_hat slips, and where it touches.
TEST(CoulombBounds, are_for_displacements_that_open_as_they_slip) {
  Problem problem = rubbed_example_1(0.5, 8);
  problem.law.previous = everywhere(problem.line, -1e-3);
  const VectorXd u = solved(problem).displacement;
  const auto [line, law] = conditions_of_coulomb(problem.line, problem.law, u);
  const Matrix2Xd w =
      displacement_against_foundation(problem.line, problem.law, u);
  const VectorXd beyond =
      contact_components(line, u).row(0).transpose() - law.gap;
  const double length = std::hypot(1, 0.5);
  const int p = problem.line.node_count();
  for (int i = 0; i < p; ++i) {
    const double slip = 0.5 * std::abs(w(1, i));
    EXPECT_NEAR(beyond[i] * length, w(0, i) + 0.5 * w(1, i) - slip, 1e-15);
    EXPECT_NEAR(beyond[p + i] * length, w(0, i) - 0.5 * w(1, i) - slip, 1e-15);
  }
}

/// The friction of a displacement that turns back along an edge is not known there.
TEST(CoulombBounds, take_slip_of_both_signs_for_none) {
  const Problem problem = rubbed_example_1(0.5, 4);
  const ContactLine& line = problem.line;
  VectorXd u = VectorXd::Zero(problem.b.size());
  for (int i = 0; i < line.node_count(); ++i)
    u[2 * line.vertex[i]] = i < 3 ? -0.01 : 0.01;
  const VectorXd gap = conditions_of_coulomb(line, problem.law, u).law.gap;
  for (int i = 0; i < line.node_count(); ++i)
    EXPECT_NEAR(gap[i], i == 2 || i == 3 ? 0 : 0.005 / std::hypot(1, 0.5),
                1e-15);
}

TEST(CoulombBounds, are_refused_where_the_theorem_is_not_written_yet) {
  const auto sentence_of = [](const Problem& problem) {
    return refusal([&] { of_the_left_side(problem); });
  };
  Problem varies = rubbed_example_1(0.2, 4);
  varies.law.friction[1] = 0.3;
  EXPECT_NE(sentence_of(varies).find("one coefficient of friction"),
            std::string::npos);
  Problem turns = rubbed_example_1(0.2, 4);
  turns.line.normal.col(1) = Vector2d(0.1, -1).normalized();
  EXPECT_NE(sentence_of(turns).find("straight contact lines"),
            std::string::npos);
  Problem limited = rubbed_example_1(0.2, 4);
  limited.law.shear_limit = everywhere(limited.line, 1);
  EXPECT_NE(sentence_of(limited).find("without a shear limit"),
            std::string::npos);
}

/// A problem on one of several nested meshes, with a quantity.
struct Nested {
  Problem problem;
  Quantity<2> quantity;

  QuantityBounds bounds() const { return bounds_of(problem, quantity); }
};

/// Does everything slip the same way in both?
bool slip_one_way(const Solved& one, const Solved& other) {
  const auto slips = [](const Solved& solved, double way) {
    const VectorXd slip = way * displacement_against_foundation(
                                    solved.problem.line, solved.problem.law,
                                    solved.body.displacement)
                                    .row(1);
    return slip.minCoeff() >= -1e-9 * slip.cwiseAbs().maxCoeff();
  };
  return (slips(one, 1) && slips(other, 1)) ||
         (slips(one, -1) && slips(other, -1));
}

bool is_below_1(const QuantityBounds& bounds) {
  return bounds.reason.find("mu kappa is") == std::string::npos;
}

/// With coarse, fine and finest meshes. The width may grow with kappa.
void require_that_they_hold_below_1(
    const std::function<Nested(int times)>& with) {
  const Nested coarse = with(0), finest = with(3);
  const QuantityBounds wide = coarse.bounds(), narrow = with(2).bounds();
  RC_PRE(moves(wide) && is_below_1(wide) && is_below_1(narrow));
  require_that_they_meet(wide, narrow);
  const Solved reference(finest.problem);
  const bool one_way = slip_one_way(Solved(coarse.problem), reference);
  RC_CLASSIFY(one_way);
  require_that_they_hold(wide, narrow.value, reference.value(finest.quantity));
}

RC_GTEST_PROP(CoulombBounds, of_nested_meshes_hold_references,
              (Random random)) {
  const RandomBlock block = random_block(random);
  const double mu = *real(0.02, 0.6);
  const Vector2d gap(*real(0, 1e-2), *real(0, 1e-3)),
      previous(*real(-1e-3, 1e-3), *real(-1e-3, 1e-3));
  const RandomQuantity quantity(block.mesh, random);
  require_that_they_hold_below_1([&](int times) -> Nested {
    Problem problem =
        with_law(block.on(subdivided(block.mesh, times)), 0, gap, previous);
    set_friction(problem, mu);
    return {problem, quantity.on(problem)};
  });
}

/// Two blocks whose meshes match.
RC_GTEST_PROP(CoulombBounds, of_nested_bodies_hold_references,
              (Random random)) {
  const int columns = *rc::gen::inRange(2, 5);
  const Mesh upper = shifted(rectangle(columns, 2, 3, 1), {0, 1}),
             lower = rectangle(columns, *rc::gen::inRange(1, 4), 3, 1);
  const double mu = *real(0.02, 0.6);
  const Vector2d shift = 1e-3 * random_vector(2, random) - Vector2d(0, 3e-3),
                 on_side = 3 * random_vector(2, random),
                 w = random_vector(2, random);
  const unsigned kind = random() % 3;
  require_that_they_hold_below_1([&](int times) -> Nested {
    Bodies two =
        bodies({subdivided(upper, times), subdivided(lower, times)},
               {material(1e3, 0.3), material(2e3, 0.2)}, {{0, bottom, 1, top}});
    Problem& problem = two.problem;
    set_friction(problem, mu);
    clamp(problem, two.label(0, top), [&](const Vector2d&) { return shift; });
    clamp(problem, two.label(1, bottom));
    add_traction(problem, two.label(1, left), on_side);
    const int label = kind == 0   ? two.label(0, left)
                      : kind == 1 ? two.label(0, bottom)
                                  : two.label(1, top);
    return {problem, on_label<2>(problem.mesh, label, w)};
  });
}

}  // namespace
}  // namespace ffcontact
