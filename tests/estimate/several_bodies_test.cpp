// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "ffcontact/estimate/error/contact_error.hpp"
#include "support/bodies.hpp"
#include "support/estimates.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr Multiplier both[] = {Multiplier::force, Multiplier::pressure};

TEST(SeveralBodiesEstimate, example_3_as_published) {
  for (const Multiplier multiplier : both) {
    const Bodies two = example_3(multiplier);
    const ContactSolution<2> solution = solved(two.problem);
    const ContactLine& line = two.problem.line;
    const auto ratio = [&](const ContactDensities& r, int end, int e) {
      return std::abs(r.tangential(end, e)) / (-0.3 * r.normal(end, e));
    };
    const ContactDensities before = edge_densities(line, solution.pressure);
    const int last = line.edge_count() - 1;
    if (multiplier == Multiplier::force) {
      EXPECT_GT(std::max(ratio(before, 0, 0), ratio(before, 1, 0)), 1)
          << "first edge";
      EXPECT_GT(std::max(ratio(before, 0, last), ratio(before, 1, last)), 1)
          << "last edge";
    }
    for (const Tractions tractions :
         {Tractions::published, Tractions::fixed, Tractions::free}) {
      const Estimate<2> estimate =
          estimated(two.problem, solution, sweeps(2, tractions));
      EXPECT_TRUE(estimate.admissible) << estimate.reason;
      const bool shifted =
          tractions == Tractions::published && multiplier == Multiplier::force;
      EXPECT_EQ(estimate.corrected_count(), shifted ? 2 : 0);
      EXPECT_LT(estimate.relative, tractions == Tractions::free        ? 0.071
                                   : tractions == Tractions::published ? 0.086
                                                                       : 0.078);
    }
  }
}

/// Parts of edges that a vertex of the other body all but meets make triangles as thin,
/// whose equilibrium suffers from rounding with the square of their thinness.
bool has_slivers(const Estimate<2>& estimate) {
  if (!estimate.refinement) return false;
  const Mesh& mesh = estimate.refinement->mesh;
  double shortest = mesh.vertices.maxCoeff();
  for (int e = 0; e < estimate.refinement->edges.count(); ++e)
    shortest = std::min(
        shortest, edge_vector(mesh, estimate.refinement->edges, e).norm());
  return shortest < 1e-3;
}

/// Whether vertices that all but meet face each other: forces on the opposite body are
/// then off by up to 1e-4 of an edge.
bool is_exact(const Estimate<2>& estimate) {
  return !estimate.refinement || estimate.refinement->exact;
}

/// Uniform compression through random interfaces is in the discrete space: no error,
/// Property 2.3.
RC_GTEST_PROP(SeveralBodiesEstimate, uniform_pressure_has_no_error,
              (Random random)) {
  const int upper = *rc::gen::inRange(1, 8), lower = *rc::gen::inRange(1, 8);
  Bodies two = bodies(
      {shifted(with_random_rows(upper, 3, 6, 4, random), {0, 5}),
       with_random_rows(lower, 3, 6, 5, random)},
      {material(70e3, 0.3), material(210e3, 0.2)}, {{0, bottom, 1, top}});
  Problem& problem = two.problem;
  add_traction(problem, two.label(0, top), {0, -7});
  prescribe(problem, two.label(1, bottom), 1);
  for (int k = 0; k < 2; ++k) prescribe(problem, two.label(k, left), 0);
  problem.law.multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  const Estimate<2> estimate = estimated(problem, solved(problem), sweeps(0));
  RC_ASSERT(estimate.relative < (is_exact(estimate) ? 1e-7 : 1e-4));
  RC_ASSERT(estimate.admissible || has_slivers(estimate));
}

/// Two blocks sheared on each other, whose traces do not match; the lower one may be
/// longer.
Problem sheared(Random& random, double mu, bool longer) {
  const int upper = *rc::gen::inRange(2, 9), lower = *rc::gen::inRange(2, 9);
  const Mesh base =
      longer ? shifted(with_random_rows(lower + 1, 3, 8, 4, random), {-1, 0})
             : with_random_rows(lower, 3, 6, 4, random);
  Bodies two = bodies(
      {shifted(with_random_rows(upper, 3, 6, 3, random), {0, 4}), base},
      {material(70e3, 0.3), material(100e3, 0.2)}, {{0, bottom, 1, top}});
  add_traction(two.problem, two.label(0, top), {1, -10});
  add_traction(two.problem, two.label(0, left), {1, 0.5});
  if (mu == 0) prescribe(two.problem, two.label(0, right), 0);
  add_body_force(two.problem, {0.1, -0.2});
  clamp(two.problem, two.label(1, bottom));
  set_friction(two.problem, mu);
  two.problem.law.multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  return two.problem;
}

RC_GTEST_PROP(SeveralBodiesEstimate,
              traces_that_do_not_match_have_an_admissible_pair,
              (Random random)) {
  const double mu = *real(0.3, 1);
  const Problem problem =
      sheared(random, *rc::gen::element(0.0, mu), *rc::gen::arbitrary<bool>());
  const ContactSolution<2> solution = solved(problem);
  RC_PRE(solution.accepted({}));
  for (const Tractions tractions : {Tractions::fixed, Tractions::free}) {
    const Estimate<2> estimate =
        estimated(problem, solution, sweeps(2, tractions));
    RC_ASSERT(estimate.cone < 1e-12);
    RC_ASSERT(estimate.equilibrium.largest() < 1e-10 || has_slivers(estimate));
    const double square = estimate.relative * estimate.relative;
    RC_ASSERT(std::abs(estimate.local.squaredNorm() - square) < 1e-10 * square);
    RC_ASSERT(estimate.admissible || has_slivers(estimate));
    const ContactLine& line =
        estimate.refinement ? estimate.refinement->line : problem.line;
    const Matrix2Xd w = contact_components(line, estimate.displacement);
    RC_ASSERT(w.row(0).maxCoeff() < 1e-12 * problem.mesh.vertices.maxCoeff());
  }
}

/// A block on a longer one, the line of which carries the multipliers.
RC_GTEST_PROP(SeveralBodiesEstimate,
              a_line_that_the_opposite_body_ends_on_has_an_admissible_pair,
              (Random random)) {
  const int upper = *rc::gen::inRange(1, 9), lower = *rc::gen::inRange(3, 9);
  const double x = -0.8 + 0.01 * *rc::gen::inRange(0, 260);
  Bodies two =
      bodies({shifted(with_random_rows(upper, 3, 5, 3, random), {x, 4}),
              shifted(with_random_rows(lower, 3, 8, 4, random), {-1, 0})},
             {material(70e3, 0.3), material(7, 0.2)}, {{1, top, 0, bottom}});
  add_traction(two.problem, two.label(0, top), {0.5, -10});
  clamp(two.problem, two.label(1, bottom));
  set_friction(two.problem, 0.4);
  two.problem.law.multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  const ContactSolution<2> solution = solved(two.problem);
  RC_PRE(solution.accepted({}));
  RC_ASSERT(std::abs(solution.force.row(0).sum() + 50) < 1e-5);
  const Estimate<2> estimate = estimated(two.problem, solution, sweeps(1));
  RC_ASSERT(estimate.cone < 1e-12);
  RC_ASSERT(estimate.equilibrium.largest() < 1e-9 || has_slivers(estimate));
  RC_ASSERT(estimate.penetration < 1e-12);
}

/// Friction alone holds the upper body sideways; its tangential resultant must survive
/// the way of tensile edges into the cone.
TEST(SeveralBodiesEstimate,
     tresca_keeps_the_resultants_of_a_body_held_by_friction) {
  for (const double slip_bound : {0.5, 1.0, 1.6, 2.5}) {
    Bodies two = bodies(
        {shifted(rectangle(8, 5, 4, 2), {2, 3}), rectangle(16, 6, 8, 3)},
        {material(70e3, 0.3), material(70e3, 0.3)}, {{0, bottom, 1, top}});
    add_traction(two.problem, two.label(0, top), {0.2, -7});
    clamp(two.problem, two.label(1, bottom));
    two.problem.law.slip_bound = everywhere(two.problem.line, slip_bound);
    const Estimate<2> estimate =
        estimated(two.problem, solved(two.problem), sweeps(2));
    EXPECT_TRUE(estimate.admissible) << slip_bound << ": " << estimate.reason;
    EXPECT_LT(estimate.relative, 0.12);
  }
}

/// Traces whose vertices all but meet are as good as matching ones, however small their
/// distance is.
TEST(SeveralBodiesEstimate, is_continuous_where_vertices_nearly_meet) {
  for (const Multiplier multiplier : both) {
    const auto estimate_of = [&](double distance) {
      Mesh lower = rectangle(8, 4, 8, 4);
      // the inner vertices of the top
      for (int v = 4 * 9 + 1; v < 5 * 9 - 1; ++v)
        lower.vertices(0, v) += distance;
      Bodies two = bodies({shifted(rectangle(8, 3, 8, 3), {0, 4}), lower},
                          {material(70e3, 0.3), material(100e3, 0.2)},
                          {{0, bottom, 1, top}});
      add_traction(two.problem, two.label(0, top), {1, -10});
      add_traction(two.problem, two.label(0, left), {1, 0.5});
      clamp(two.problem, two.label(1, bottom));
      set_friction(two.problem, 0.4);
      two.problem.law.multiplier = multiplier;
      return estimated(two.problem, solved(two.problem), sweeps(2));
    };
    const double matching = estimate_of(0).relative;
    for (const double distance :
         {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
      const Estimate<2> estimate = estimate_of(distance);
      EXPECT_NEAR(estimate.relative, matching, 0.02 * matching) << distance;
      EXPECT_TRUE(estimate.admissible) << distance << ": " << estimate.reason;
    }
  }
}

/// eps_E^2 of facing triangles has half of the contact part of their edge each, that of a
/// triangle on a foundation all of it.
void shares_add_up(const Problem& problem) {
  const Estimate<2> estimate = estimated(problem, solved(problem), sweeps(0));
  ASSERT_FALSE(estimate.refinement.has_value());
  const Matrix3Xd stress =
      stresses(problem.mesh, problem.hooke, estimate.displacement);
  VectorXd shares =
      estimate.local.cwiseAbs2() * std::pow(estimate.e / estimate.relative, 2);
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    shares[t] -= energy(
        corners_of(problem.mesh, t), problem.hooke[t].inverse(),
        estimate.stress[t] - SubcellStress<2>(stress.col(t).replicate<1, 9>()));
  const ContactLine& line = problem.line;
  const VectorXd contact = contact_error(line, problem.law, estimate.tractions,
                                         estimate.displacement);
  ASSERT_GT(contact.maxCoeff(), 1e-6 * std::pow(estimate.e, 2));
  for (int e = 0; e < line.edge_count(); ++e) {
    const bool faced = line.against_a_body() && line.opposite_edge[e] >= 0;
    shares[problem.edges.cells(0, line.edge[e])] -=
        contact[e] / (faced ? 2 : 1);
    if (faced)
      shares[problem.edges.cells(0, line.opposite_edge[e])] -= contact[e] / 2;
  }
  EXPECT_LT(shares.cwiseAbs().maxCoeff(), 1e-10 * std::pow(estimate.e, 2));
}

TEST(SeveralBodiesEstimate, shares_the_contact_part_between_facing_triangles) {
  Bodies two = bodies(
      {shifted(rectangle(6, 3, 6, 3), {0, 4}), rectangle(6, 4, 6, 4)},
      {material(70e3, 0.3), material(100e3, 0.2)}, {{0, bottom, 1, top}});
  add_traction(two.problem, two.label(0, top), {3, -5});
  clamp(two.problem, two.label(1, bottom));
  set_friction(two.problem, 0.8);
  shares_add_up(two.problem);
  shares_add_up(example_1(Multiplier::force, 4));
}

}  // namespace
}  // namespace ffcontact
