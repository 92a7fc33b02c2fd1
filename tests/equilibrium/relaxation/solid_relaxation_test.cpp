// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <malloc.h>

#include <Eigen/LU>
#include <set>

#include "ffcontact/equilibrium/relaxation/facet_relaxation.hpp"
#include "support/refusals.hpp"
#include "support/relaxed_solid.hpp"
#include "support/slivers.hpp"
#include "support/smooth_solid.hpp"
#include "support/threads.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(SolidRelaxation, keeps_balance_and_known_tractions,
              (Random random)) {
  RelaxedSolid solid(any_solid(random));
  const FaceMoments before = solid.moments;
  const double imbalance = solid.imbalance();
  solid.relax(8);
  RC_ASSERT(solid.imbalance() < imbalance + 1e-12);
  for (int f = 0; f < before.cols(); ++f)
    for (int row = 0; row < 9; ++row)
      if (solid.boundary.known(row % 3, f))
        RC_ASSERT(solid.moments(row, f) == before(row, f));
}

RC_GTEST_PROP(SolidRelaxation, falls_by_what_the_energy_falls,
              (Random random)) {
  RelaxedSolid solid(any_solid(random));
  const double before = solid.square();
  double sum = 0;
  for (double fall : solid.relax(6)) {
    RC_ASSERT(fall > 0);
    sum += fall;
  }
  RC_ASSERT(std::abs(before - sum - solid.square()) < 1e-6 * before);
}

double allocated() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

TEST(SolidRelaxation, takes_as_much_memory_as_it_says) {
  Random random(1);
  const RelaxedSolid solid(
      random_loaded_solid(brick({12, 12, 12}, {1, 1, 1}), random));
  const LoadedFacets<3>& body = solid.setting.body;
  const FacetShare whole = whole_share<3>(body.topology);
  const NoExchange<3> none;
  const double before = allocated();
  const FacetDescent<3> descent(body, solid.moments, whole, none);
  const double taken = allocated() - before;
  if (taken == 0) GTEST_SKIP() << "a sanitizer's own memory";
  const double said = FacetDescent<3>::bytes(body.topology);
  EXPECT_GT(said, 0.9 * taken);
  EXPECT_LT(said, 1.1 * taken);
}

TEST(SolidRelaxation, is_refused_where_there_is_no_room) {
  const Topology<3> topology = topology_of(brick({2, 1, 1}, {2, 1, 1}));
  const FacetTopology<3> facets = topology;
  const double bytes = FacetDescent<3>::bytes(facets);
  require_room_for_relaxation<3>(facets, bytes);
  EXPECT_TRUE(says(
      refusal([&] { require_room_for_relaxation<3>(facets, 0.99 * bytes); }),
      "the estimate of 12 tetrahedra takes "));
}

/// By a sparse solve, the least energy that moments in equilibrium can have.
double least_square(RelaxedSolid& solid) {
  for (int round = 0; round < 20; ++round) solid.relax(50);
  return solid.square();
}

TEST(SolidRelaxation, ends_at_the_least_energy) {
  // No other self-equilibrated moments lower it: brute force over all of them.
  Random random(5);
  RelaxedSolid solid(random_loaded_solid(
      moved(brick({2, 1, 1}, {2, 1, 1}), 1, 0.1, random), random));
  const double relaxed = least_square(solid);

  const auto& [mesh, faces, edges, stars] = solid.body.topology;
  const int unknowns = 9 * faces.count(), cells = mesh.cell_count();
  MatrixXd balance = MatrixXd::Zero(6 * cells + unknowns, unknowns);
  MatrixXd H = MatrixXd::Zero(unknowns, unknowns);
  VectorXd slope = VectorXd::Zero(unknowns);
  std::array<Matrix9d, 4> identity;
  identity.fill(Matrix9d::Identity());
  for (int t = 0; t < cells; ++t) {
    const CellCorners<3> x = corners_of(mesh, t);
    const Matrix6d compliance = solid.body.hooke[t].inverse();
    MatrixXd to_loads = MatrixXd::Zero(36, unknowns);
    for (int f : faces.of_cell.col(t))
      for (int row = 0; row < 9; ++row) {
        FaceMoments unit = FaceMoments::Zero(9, faces.count());
        unit(row, f) = 1;
        to_loads.col(9 * f + row) = loads_of(mesh, faces, unit, t).reshaped();
      }
    H += to_loads.transpose() * facet_energy<3>(x, compliance, identity) *
         to_loads;
    slope += to_loads.transpose() *
             facet_slope<3>(
                 x, compliance,
                 difference_stress<3>(solid.setting.body, solid.moments, t),
                 identity);
    balance.middleRows(6 * t, 6) =
        balance_conditions(x).leftCols<36>() * to_loads;
  }
  for (int f = 0; f < faces.count(); ++f)
    for (int row = 0; row < 9; ++row)
      if (solid.boundary.known(row % 3, f))
        balance(6 * cells + 9 * f + row, 9 * f + row) = 1;
  Eigen::FullPivLU<MatrixXd> lu(balance);
  lu.setThreshold(1e-9);
  const MatrixXd free = lu.kernel();
  ASSERT_GT(free.cols(), 20);
  const VectorXd step =
      -(free.transpose() * H * free).ldlt().solve(free.transpose() * slope);
  const double fall = -step.dot(free.transpose() * slope);
  EXPECT_GE(fall, -1e-12 * relaxed);
  EXPECT_LT(fall, 1e-9 * relaxed);
}

/// e / |u - u_h| before and after every one of 16 steps of relaxation.
std::vector<double> effectivities(const SolidMesh& mesh, bool mixed) {
  const SmoothSolid exact;
  RelaxedSolid solid(smooth_body(exact, mesh, mixed));
  const double error = error_of(exact, solid.body, solid.stress.mean);
  std::vector<double> squares{solid.square()}, result;
  for (double fall : solid.relax(16)) squares.push_back(squares.back() - fall);
  for (double square : squares) result.push_back(std::sqrt(square) / error);
  return result;
}

// Published figures of the method are not at hand; an independent slow implementation
// has 4.9 to 6.2 at first, 1.20 and 1.29 after four steps and 1.06 and 1.09 after ten on
// another smooth solution. Below 1 by the oscillation of the data at most.

TEST(SolidRelaxation, effectivity_on_regular_bricks) {
  const std::vector<double> e =
      effectivities(brick({4, 4, 4}, {1, 1, 1}), true);
  EXPECT_GT(e[0], 4);
  EXPECT_LT(e[1], 1.7);
  EXPECT_LT(e[4], 1.2);
  EXPECT_LT(e[10], 1.06);
  EXPECT_GT(e[16], 1);
}

TEST(SolidRelaxation, effectivity_with_displacements_given_all_around) {
  const std::vector<double> e =
      effectivities(brick({4, 4, 4}, {1, 1, 1}), false);
  EXPECT_LT(e[4], 1.2);
  EXPECT_LT(e[10], 1.05);
  EXPECT_GT(e[16], 0.99);
}

TEST(SolidRelaxation, effectivity_on_moved_bricks) {
  std::mt19937 random(1);
  const std::vector<double> e = effectivities(
      shuffled(moved(brick({4, 4, 4}, {1, 1, 1}), 0.25, 0.16, random), random),
      true);
  EXPECT_LT(e[4], 1.25);
  EXPECT_LT(e[10], 1.09);
  EXPECT_GT(e[16], 1);
}

TEST(SolidRelaxation, effectivity_on_slivers) {
  // six of the 27 inner vertices are in tetrahedra with an angle of 1 degree
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    const SolidMesh mesh = shuffled(
        with_slivers(moved(brick({4, 4, 4}, {1, 1, 1}), 0.25, 0.1, random), 6,
                     1, random),
        random);
    const std::vector<double> e = effectivities(mesh, true);
    EXPECT_LT(e[16], 0.05 * e[0]);
    EXPECT_GT(e[16], 1);
    RelaxedSolid solid(smooth_body({}, mesh, true));
    solid.relax(16);
    EXPECT_LT(solid.imbalance(), 1e-10);
  }
}

/// Steps without a number, and e / |u - u_h| after them.
struct AutomaticSteps {
  std::size_t steps;
  double effectivity;

  AutomaticSteps(const SolidMesh& mesh, double nu) {
    SmoothSolid exact;
    exact.nu = nu;
    RelaxedSolid solid(smooth_body(exact, mesh, true));
    const double error = error_of(exact, solid.body, solid.stress.mean);
    steps = relax_facets<3>(solid.setting, {}, solid.moments).size();
    effectivity = std::sqrt(solid.square()) / error;
  }
};

TEST(SolidRelaxation, goes_on_where_bodies_are_nearly_incompressible) {
  // 16 steps leave 1.57 and 1.37 at nu 0.49
  for (const int n : {4, 8}) {
    const SolidMesh mesh = brick({n, n, n}, {1, 1, 1});
    const AutomaticSteps usual(mesh, 0.3), more(mesh, 0.49);
    EXPECT_EQ(usual.steps, 16u);
    EXPECT_GT(usual.effectivity, 1);
    EXPECT_LT(usual.effectivity, 1.05);
    EXPECT_GE(more.steps, 24u);
    EXPECT_LE(more.steps, 32u);
    EXPECT_GT(more.effectivity, 1);
    EXPECT_LT(more.effectivity, n == 4 ? 1.5 : 1.3);
  }
}

TEST(SolidRelaxation, without_a_number_goes_on_while_four_steps_lower_e) {
  const SolidMesh mesh = brick({3, 3, 3}, {1, 1, 1});
  std::set<std::size_t> counts;
  for (double nu : {0.2, 0.4, 0.45, 0.47, 0.49, 0.499}) {
    SmoothSolid exact;
    exact.nu = nu;
    RelaxedSolid all(smooth_body(exact, mesh, true)), some(all.body);
    std::vector<double> e{std::sqrt(all.square())};
    for (double fall : all.relax(100))
      e.push_back(std::sqrt(e.back() * e.back() - fall));
    std::size_t last = 16;
    double worth = 0.03;
    for (; last < 96 && e[last] < (1 - worth) * e[last - 4]; last += 4)
      worth = 0.02;
    EXPECT_EQ(relax_facets<3>(some.setting, {}, some.moments).size(), last);
    counts.insert(last);
  }
  EXPECT_GT(counts.size(), 2u);
}

TEST(SolidRelaxation, has_the_same_digits_on_two_threads) {
  Random random(6);
  RelaxedSolid one(any_solid(random));
  FaceMoments two = one.moments;
  const std::vector<double> falls = on_threads(2, [&] {
    return relax_facets<3>(one.setting, {5, 0}, two);
  });
  EXPECT_EQ(one.relax(5), falls);
  EXPECT_EQ(one.moments, two);
}

TEST(SolidRelaxation, stops_where_a_step_lowers_e_by_less_than_asked) {
  Random random(2);
  RelaxedSolid all(any_solid(random)), some(all.body);
  std::vector<double> squares{all.square()};
  for (double fall : all.relax(12)) squares.push_back(squares.back() - fall);
  const std::size_t steps = some.relax(12, 0.05).size();
  const auto lowered = [&](std::size_t step) {
    return 1 - std::sqrt(squares[step] / squares[step - 1]);
  };
  ASSERT_LT(steps, 12u);
  EXPECT_LT(lowered(steps), 0.05);
  for (std::size_t k = 1; k < steps; ++k) EXPECT_GE(lowered(k), 0.05);
}

}  // namespace
}  // namespace ffcontact
