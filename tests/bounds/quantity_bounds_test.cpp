// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/quantity_bounds.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "support/bounded.hpp"
#include "support/estimates.hpp"
#include "support/quantities.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Mean of u_x on the left quarter of the bottom of example 1.
Quantity<2> mean_on_the_first_quarter(const Problem& problem) {
  Quantity<2> quantity = no_quantity<2>(problem.mesh);
  for (Index e = 0; e < problem.mesh.boundary.cols(); ++e) {
    const Matrix2d ends =
        facet_points<2>(problem.mesh, problem.mesh.boundary.col(e));
    if (problem.mesh.boundary_label[e] == bottom && ends.row(0).mean() < 20) {
      const double half = boundary_measure<2>(problem.mesh, e) / 2 / 20;
      quantity.tractions.col(e) << half, 0, half, 0;
    }
  }
  return quantity;
}

/// Its mean in a box of whole cells.
Quantity<2> mean_stress(const Problem& problem, const Vector3d& M,
                        const Vector2d& low, const Vector2d& high) {
  return stress_of(problem, M / (high - low).prod(), [&](int t) {
    const Vector2d x = centroid_of(problem.mesh, t);
    return (x.array() > low.array()).all() && (x.array() < high.array()).all();
  });
}

Problem tresca_example_1(double bound, int cells) {
  Problem problem = example_1(Multiplier::force, cells);
  set_friction(problem, 0);
  if (bound > 0) problem.law.slip_bound = everywhere(problem.line, bound);
  return problem;
}

/// With the widths of bounds by the best stresses of the mesh, in % of the value.
struct KnownBounds {
  double bound, exact, wide_with_8, wide_with_16;
};

void expect_known(const KnownBounds& known,
                  const std::function<Quantity<2>(const Problem&)>& quantity) {
  for (const int cells : {8, 16}) {
    const Solved solved(tresca_example_1(known.bound, cells));
    const QuantityBounds found = solved.bounds(quantity(solved.problem));
    EXPECT_LT(found.lower, known.exact);
    EXPECT_GT(found.upper, known.exact);
    const double wide = cells == 8 ? known.wide_with_8 : known.wide_with_16;
    EXPECT_LT(found.upper - found.lower,
              1.1 * wide / 100 * std::abs(known.exact));
  }
}

TEST(QuantityBounds, have_known_values_between_them_and_are_known_to_be_near) {
  const auto mean_on_the_left = [](const Problem& problem) {
    return on_label<2>(problem.mesh, left, {1.0 / 40, 0});
  };
  expect_known({0, 0.0263411, 4.60, 1.75}, mean_on_the_left);
  expect_known({2, 0.020426, 7.44, 3.20}, mean_on_the_left);
  expect_known({2, 0.0170116, 44.9, 21.2}, mean_on_the_first_quarter);
  expect_known({0, -1.05584, 134, 71}, [](const Problem& problem) {
    return mean_stress(problem, {0, 1, 0}, {20, 10}, {40, 30});
  });
}

TEST(QuantityBounds, are_apart_by_what_the_cells_contribute) {
  const Solved solved(tresca_example_1(2, 8));
  const QuantityBounds found =
      solved.bounds(mean_stress(solved.problem, {0, 1, 0}, {20, 10}, {40, 30}));
  const double width = found.upper - found.lower;
  EXPECT_NEAR(found.local.sum(), width, 1e-10 * width);
  EXPECT_GE(found.local.minCoeff(), -1e-12 * width);
}

/// Of the box.
QuantityBounds bounds_of_stress(const Solved& solved, int sweeps,
                                int further_turns) {
  BoundSettings settings;
  settings.relaxation.steps = sweeps;
  settings.further_turns = further_turns;
  return solved.bounds(
      mean_stress(solved.problem, {0, 1, 0}, {20, 10}, {40, 30}), settings);
}

/// What each further turn takes off a bound, the last of which is below what is worth it.
void expect_to_end(const VectorXd& gains, double worthwhile) {
  bool ended = false;
  for (const double gain : gains) {
    EXPECT_GE(gain, 0);
    if (ended) {
      EXPECT_EQ(gain, 0);
    }
    ended = ended || gain < worthwhile;
  }
  EXPECT_TRUE(ended);
}

TEST(QuantityBounds, get_narrower_by_further_turns_while_these_gain) {
  const Solved solved(tresca_example_1(0, 8));
  constexpr int most = 7;
  VectorXd rises(most), falls(most);
  const QuantityBounds wide = bounds_of_stress(solved, 1, 0);
  QuantityBounds last = wide;
  for (int k = 0; k < most; ++k) {
    const QuantityBounds next = bounds_of_stress(solved, 1, k + 1);
    rises[k] = next.lower - last.lower;
    falls[k] = last.upper - next.upper;
    EXPECT_LT(next.lower, -1.05584);
    EXPECT_GT(next.upper, -1.05584);
    EXPECT_NEAR(next.local.sum(), next.width(), 1e-10 * next.width());
    last = next;
  }
  expect_to_end(rises, 0.01 * wide.width());
  expect_to_end(falls, 0.01 * wide.width());
}

TEST(QuantityBounds, hardly_depend_on_the_sweeps_that_they_start_with) {
  const Solved solved(tresca_example_1(2, 8));
  const double of_one = bounds_of_stress(solved, 1, 5).width(),
               of_eight = bounds_of_stress(solved, 8, 5).width();
  EXPECT_NEAR(of_one, of_eight, 0.01 * of_eight);
}

TEST(QuantityBounds, are_none_where_the_mesh_knows_nothing_of_the_quantity) {
  // the triangle in the corner has no free vertex, but its third side moves
  Problem problem = body(rectangle(2, 2, 1, 1), material(1, 0.3));
  clamp(problem, left);
  clamp(problem, top);
  add_traction(problem, right, {1, 0});
  const Solved solved(problem);
  const QuantityBounds found =
      solved.bounds(stress_of(problem, {1, 0, 0}, [&](int t) {
        const Vector2d x = centroid_of(problem.mesh, t);
        return x.y() - x.x() > 0.6;
      }));
  EXPECT_FALSE(found.found());
  EXPECT_FALSE(found.reason.empty());
}

TEST(QuantityBounds, are_none_where_nothing_is_loaded) {
  Problem problem = body(rectangle(2, 2, 1, 1), material(1, 0.3));
  clamp(problem, top);
  const Solved solved(problem);
  const QuantityBounds found =
      solved.bounds(on_label<2>(problem.mesh, left, {1, 0}));
  EXPECT_FALSE(found.found());
  EXPECT_EQ(found.reason, "the loads make no stresses");
}

TEST(QuantityBounds, turn_with_the_sign_and_move_with_the_constant) {
  const Solved solved(tresca_example_1(2, 8));
  Quantity<2> quantity = on_label<2>(solved.problem.mesh, left, {1.0 / 40, 0});
  const QuantityBounds found = solved.bounds(quantity);
  quantity.tractions *= -1;
  quantity.constant = 3;
  const QuantityBounds turned = solved.bounds(quantity);
  EXPECT_NEAR(turned.lower, 3 - found.upper, 1e-9);
  EXPECT_NEAR(turned.upper, 3 - found.lower, 1e-9);
}

/// The solution is linear, and so is the response to the quantity.
TEST(QuantityBounds, have_what_the_mesh_knows_exactly_between_them) {
  const Solved solved(example_2(Multiplier::force, 0, 4));
  const QuantityBounds found =
      solved.bounds(on_label<2>(solved.problem.mesh, top, {0, 1}));
  // u_y = -5 y (1 - nu^2) / E
  const double exact = -5 * 40 * 40 * (1 - 0.2 * 0.2) / 13e3;
  EXPECT_LE(found.lower, exact);
  EXPECT_GE(found.upper, exact);
  EXPECT_LT(found.width(), 1e-10 * std::abs(exact));
}

TEST(QuantityBounds, are_the_same_in_any_units) {
  const Quantity<2> mean =
      on_label<2>(tresca_example_1(2, 8).mesh, left, {1.0 / 40, 0});
  const QuantityBounds in_mm = Solved(tresca_example_1(2, 8)).bounds(mean);
  for (const double unit : {1e-9, 1e9}) {
    Problem problem = tresca_example_1(2 * unit, 8);
    for (Matrix3d& C : problem.hooke) C *= unit;
    for (Index k = 0; k < problem.A.nonZeros(); ++k)
      if (problem.A.valuePtr()[k] != penalty) problem.A.valuePtr()[k] *= unit;
    problem.b *= unit;
    problem.neumann *= unit;
    const QuantityBounds found = Solved(problem).bounds(mean);
    EXPECT_NEAR(found.lower, in_mm.lower, 1e-6 * in_mm.width());
    EXPECT_NEAR(found.upper, in_mm.upper, 1e-6 * in_mm.width());
  }
}

TEST(QuantityBounds, are_refused_with_gaps_beside_which_displacements_round) {
  Problem problem = tresca_example_1(0, 4);
  problem.law.gap = everywhere(problem.line, 0);
  problem.law.gap[2] = 1e10;
  const Solved solved(problem);
  const std::string sentence = refusal([&] {
    solved.bounds(on_label<2>(problem.mesh, left, {1, 0}));
  });
  EXPECT_NE(sentence.find("1000 times the largest displacement"),
            std::string::npos);
}

TEST(QuantityBounds, are_refused_with_coulombs_law) {
  const Solved solved(example_1(Multiplier::force, 4));
  EXPECT_EQ(refusal([&] {
              solved.bounds(on_label<2>(solved.problem.mesh, left, {1, 0}));
            }),
            "bounds of quantities are strict for contact without friction and "
            "for Tresca's law alone: state the contact with slipbound=, e.g. "
            "that of the pressures found, or friction=0; of plane bodies "
            "without a shear limit, coulomb=true takes Coulomb's law under a "
            "hypothesis");
}

}  // namespace
}  // namespace ffcontact
