// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/cone_correction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/problems.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// One contact edge of length 1 with its law.
struct EdgeProblem {
  ContactLine line;
  ContactLaw<2> law;
};
EdgeProblem one_edge(double mu) {
  const Problem problem = body(rectangle(1, 1, 1, 1), material(1, 0));
  EdgeProblem edge{problem.line, problem.law};
  edge.law.friction = everywhere(problem.line, mu);
  return edge;
}

EdgeProblem one_edge_of_tresca(double bound) {
  EdgeProblem edge = one_edge(0);
  edge.law.slip_bound = everywhere(edge.line, bound);
  return edge;
}

ContactDensities densities_of(const Vector2d& normal,
                              const Vector2d& tangential) {
  return {normal, tangential};
}

ContactDensities random_densities(Index edges, Random& random) {
  return {random_matrix(2, edges, random).array() - 0.7,
          random_matrix(2, edges, random)};
}

bool inside(const Vector2d& limits, const Vector2d& tangential, double d) {
  return std::abs(tangential[0] - d) <= limits[0] + 1e-12 &&
         std::abs(tangential[1] + d) <= limits[1] + 1e-12;
}

/// Smallest |d| on a grid of steps 0.01 that brings both ends inside, or infinity.
double smallest_shift_on_grid(const Vector2d& limits,
                              const Vector2d& tangential) {
  for (int step = 0; step <= 400; ++step)
    for (double d : {0.01 * step, -0.01 * step})
      if (inside(limits, tangential, d)) return std::abs(d);
  return std::numeric_limits<double>::infinity();
}

RC_GTEST_PROP(ConeCorrection, shift_is_the_smallest_one_on_a_grid,
              (Random random)) {
  // Values on the grid itself, so that the smallest shift is one of its points.
  const auto on_grid = [&]() -> Vector2d {
    return 0.01 * (100 * random_vector(2, random).array()).round();
  };
  const EdgeProblem edge = one_edge(1);
  const Vector2d limits = on_grid().cwiseAbs(), tangential = on_grid();
  const ConeCorrection correction =
      correct_to_cone(edge.line, edge.law, densities_of(-limits, tangential));
  const double smallest = smallest_shift_on_grid(limits, tangential);
  RC_ASSERT(correction.uncorrected.empty() == std::isfinite(smallest));
  if (std::isfinite(smallest))
    RC_ASSERT(std::abs(std::abs(correction.shift[0]) - smallest) < 1e-12);
}

RC_GTEST_PROP(ConeCorrection,
              shift_exists_if_and_only_if_the_resultant_is_in_the_cone,
              (Random random)) {
  const double mu = *real(0, 2);
  const EdgeProblem edge = one_edge(mu);
  const ContactDensities densities = random_densities(1, random);
  const ConeCorrection correction =
      correct_to_cone(edge.line, edge.law, densities);
  const bool exists =
      densities.normal.maxCoeff() <= 0 &&
      std::abs(densities.tangential.sum()) <= -mu * densities.normal.sum();
  RC_ASSERT(correction.uncorrected.empty() == exists);
}

RC_GTEST_PROP(ConeCorrection,
              brings_corrected_edges_inside_and_leaves_the_others_alone,
              (Random random)) {
  const Problem problem =
      body(irregular(6, 2, 6, 2, random), material(1, 0), {bottom, left});
  ContactLaw<2> law = problem.law;
  law.friction = random_vector(problem.line.node_count(), random).cwiseAbs();
  const ContactDensities densities =
      random_densities(problem.line.edge_count(), random);
  ConeCorrection correction = correct_to_cone(problem.line, law, densities);
  RC_ASSERT(correction.densities.normal == densities.normal);
  for (int e : correction.uncorrected) {
    RC_ASSERT(correction.densities.tangential.col(e) ==
              densities.tangential.col(e));
    RC_ASSERT(correction.shift[e] == 0);
    correction.densities.normal.col(e).setZero();
    correction.densities.tangential.col(e).setZero();
  }
  RC_ASSERT(cone_defect(problem.line, law, correction.densities) < 1e-12);
}

RC_GTEST_PROP(ConeCorrection, resultant_of_every_edge_is_unchanged,
              (Random random)) {
  const Problem problem = body(irregular(6, 2, 6, 2, random), material(1, 0));
  ContactLaw<2> law = problem.law;
  law.friction = everywhere(problem.line, *real(0, 2));
  const ContactDensities densities =
      random_densities(problem.line.edge_count(), random);
  const ConeCorrection correction =
      correct_to_cone(problem.line, law, densities);
  const Eigen::RowVectorXd change =
      correction.densities.tangential.colwise().sum() -
      densities.tangential.colwise().sum();
  RC_ASSERT(change.cwiseAbs().maxCoeff() < 1e-15);
  RC_ASSERT(correction.corrected_count() ==
            (correction.shift.array() != 0).count());
}

RC_GTEST_PROP(ConeCorrection, a_corrected_density_is_not_corrected_again,
              (Random random)) {
  const EdgeProblem edge = one_edge(*real(0, 2));
  const ConeCorrection once =
      correct_to_cone(edge.line, edge.law, random_densities(1, random));
  const ConeCorrection twice =
      correct_to_cone(edge.line, edge.law, once.densities);
  RC_ASSERT(twice.shift[0] == 0);
}

TEST(ConeCorrection, with_tresca_compares_with_the_slip_bound) {
  const EdgeProblem edge = one_edge_of_tresca(1);
  const ConeCorrection correction =
      correct_to_cone(edge.line, edge.law, densities_of({-1, -1}, {1.5, 0.25}));
  EXPECT_DOUBLE_EQ(correction.shift[0], 0.5);
  EXPECT_EQ(
      correct_to_cone(edge.line, edge.law, densities_of({-9, -9}, {1.5, 0.75}))
          .uncorrected,
      std::vector<int>{0});
}

TEST(ConeCorrection, tension_at_one_end_is_left_alone) {
  const EdgeProblem edge = one_edge(1);
  EXPECT_EQ(
      correct_to_cone(edge.line, edge.law, densities_of({-5, 0.1}, {0, 0}))
          .uncorrected,
      std::vector<int>{0});
}

TEST(ConeDefect, is_zero_inside_and_sees_one_spoiled_number) {
  const EdgeProblem edge = one_edge(0.5);
  const auto defect = [&](const ContactDensities& densities) {
    return cone_defect(edge.line, edge.law, densities);
  };
  // on the cone at both ends
  ContactDensities densities = densities_of({-2, -4}, {1, -2});
  EXPECT_EQ(defect(densities), 0);
  densities.tangential(1, 0) = -2.004;
  EXPECT_NEAR(defect(densities), 0.004 / 4, 1e-15);
  densities = densities_of({0.004, -4}, {0, -2});
  EXPECT_NEAR(defect(densities), 0.004 / 4, 1e-15);
  EXPECT_EQ(defect(densities_of({0, 0}, {0, 0})), 0);
}

/// Worst of r_n and |r_t| - c at many points of an edge, c by the lower bounds of the
/// coefficient and of the shear limit.
double worst_by_points(const EdgeProblem& edge, const ContactDensities& r) {
  const ConesAtEnds cones = least_cones(edge.line, edge.law, 0);
  double worst = r.normal.maxCoeff();
  for (int k = 0; k <= 1000; ++k) {
    const Vector2d at(1 - k / 1000., k / 1000.);
    const double p = std::max(0.0, -at.dot(r.normal.col(0)));
    double c = at.dot(Vector2d(cones[0].cohesion, cones[1].cohesion)) +
               p * at.dot(Vector2d(cones[0].friction, cones[1].friction));
    if (edge.law.limited()) c = std::min(c, at.dot(edge.law.shear_limit));
    worst = std::max(worst, std::abs(at.dot(r.tangential.col(0))) - c);
  }
  return worst;
}

EdgeProblem random_edge(Random& random) {
  EdgeProblem edge = one_edge(0);
  edge.law.friction = random_vector(2, random).cwiseAbs();
  if (*rc::gen::inRange(0, 4) == 0)
    edge.law.friction[*rc::gen::inRange(0, 2)] = 0;
  switch (*rc::gen::inRange(0, 3)) {
    case 0: break;
    case 1: edge.law.slip_bound = edge.law.friction; break;
    default: edge.law.shear_limit = 0.5 * random_vector(2, random).cwiseAbs();
  }
  return edge;
}

RC_GTEST_PROP(ConeDefect, is_the_largest_violation_along_the_edge,
              (Random random)) {
  const EdgeProblem edge = random_edge(random);
  const ContactDensities r = random_densities(1, random);
  const double scale = std::max(r.normal.cwiseAbs().maxCoeff(),
                                r.tangential.cwiseAbs().maxCoeff());
  if (r.normal.maxCoeff() > 0) return;  // then p has a kink
  RC_ASSERT(std::abs(cone_defect(edge.line, edge.law, r) -
                     std::max(0.0, worst_by_points(edge, r)) / scale) < 1e-5);
}

RC_GTEST_PROP(ConeCorrection,
              with_a_shear_limit_is_the_smallest_shift_into_the_cone,
              (Random random)) {
  EdgeProblem edge = one_edge(1);
  edge.law.shear_limit = random_vector(2, random).cwiseAbs();
  const ContactDensities r = random_densities(1, random);
  const ConeCorrection correction = correct_to_cone(edge.line, edge.law, r);
  if (!correction.uncorrected.empty()) return;
  RC_ASSERT(cone_defect(edge.line, edge.law, correction.densities) < 1e-12);
  if (correction.shift[0] == 0) return;
  ContactDensities less = r;
  less.tangential.col(0) += 0.999 * correction.shift[0] * Vector2d(-1, 1);
  RC_ASSERT(cone_defect(edge.line, edge.law, less) > 0);
}

RC_GTEST_PROP(EdgeCone, is_the_cone_all_along_the_edge, (Random random)) {
  const EdgeProblem edge = random_edge(random);
  ContactDensities r = random_densities(1, random);
  const EdgeCone cone = edge_cone(edge.line, edge.law, 0);
  for (int end = 0; end < 2; ++end)
    if (cone.frictionless[end]) r.tangential(end, 0) = 0;
  const bool allowed =
      ((cone.C * end_values(r, 0) - cone.d).array() >= 0).all();
  if (allowed) RC_ASSERT(worst_by_points(edge, r) <= 1e-14);
  const bool constant =
      edge.law.tresca() || edge.law.friction[0] == edge.law.friction[1];
  if (constant) RC_ASSERT(allowed == (worst_by_points(edge, r) <= 0));
}

RC_GTEST_PROP(EdgeCone, is_hardly_narrower_than_the_exact_one,
              (Random random)) {
  const EdgeProblem edge = random_edge(random);
  const double p[] = {*real(0.01, 1), *real(0.01, 1)};
  const Vector4d r(-p[0], *real(-1, 1), -p[1], *real(-1, 1));
  ContactDensities in_cone = random_densities(1, random), larger = in_cone;
  set_end_values(in_cone, 0, clamped_to_cone(edge.line, edge.law, 0, r));
  larger = in_cone;
  larger.tangential *= 1.04;
  const bool clamped =
      (in_cone.tangential.col(0) - Vector2d(r[1], r[3])).norm() > 1e-12;
  if (clamped) RC_ASSERT(worst_by_points(edge, larger) > -1e-12);
}

TEST(EdgeCone, of_friction_that_varies_is_narrower_than_at_its_ends) {
  EdgeProblem edge = one_edge(0);
  edge.law.friction << 0.2, 1;
  // in the cone at both ends, not between them
  const ContactDensities r = densities_of({-1, -5}, {0.2, 5});
  EXPECT_GT(cone_defect(edge.line, edge.law, r), 0.01);
  EXPECT_EQ(correct_to_cone(edge.line, edge.law, r).uncorrected,
            std::vector<int>{0});
  edge.law.between_nodes = {Vector2d(1, 1), Vector2d(1, 1)};
  EXPECT_EQ(cone_defect(edge.line, edge.law, r), 0);
}

RC_GTEST_PROP(ClampedToCone, is_in_the_cone_and_leaves_what_is_in_it,
              (Random random)) {
  const EdgeProblem edge = random_edge(random);
  ContactDensities r = random_densities(1, random);
  const Vector4d clamped =
      clamped_to_cone(edge.line, edge.law, 0, end_values(r, 0));
  set_end_values(r, 0, clamped);
  RC_ASSERT(cone_defect(edge.line, edge.law, r) <= 1e-15);
  RC_ASSERT(clamped_to_cone(edge.line, edge.law, 0, clamped)
                .isApprox(clamped, 1e-15));
}

TEST(ClampedToCone,
     of_friction_that_varies_cuts_off_what_leaves_it_between_the_ends) {
  EdgeProblem edge = one_edge(0);
  edge.law.friction << 0.2, 1;
  // in the cone at both ends, not between them
  ContactDensities r = densities_of({-1, -5}, {0.2, 5});
  set_end_values(r, 0,
                 clamped_to_cone(edge.line, edge.law, 0, end_values(r, 0)));
  EXPECT_LE(cone_defect(edge.line, edge.law, r), 1e-15);
  EXPECT_GT(r.tangential.sum(), 1.9);  // of 0.2 * 5 + 1 * 1
}

TEST(EdgeDensities, are_the_nodal_values_at_both_ends) {
  const Problem problem = body(rectangle(3, 1, 3, 1), material(1, 0));
  Matrix2Xd pressure(2, 4);
  pressure << 1, 2, 3, 4, 5, 6, 7, 8;
  const ContactDensities densities = edge_densities(problem.line, pressure);
  EXPECT_EQ(densities.normal, (Matrix2Xd(2, 3) << 1, 2, 3, 2, 3, 4).finished());
  EXPECT_EQ(densities.tangential,
            (Matrix2Xd(2, 3) << 5, 6, 7, 6, 7, 8).finished());
}

TEST(ConeCorrection, refuses_densities_of_another_line_or_not_finite) {
  const EdgeProblem edge = one_edge(1);
  const auto refusal_of = [&](const ContactDensities& densities) {
    return refusal([&] { correct_to_cone(edge.line, edge.law, densities); });
  };
  EXPECT_EQ(refusal_of({Matrix2Xd::Zero(2, 2), Matrix2Xd::Zero(2, 1)}),
            "normal densities has 2 values where 1 are needed");
  EXPECT_EQ(refusal_of(densities_of({0, 0}, {0, std::nan("")})),
            "tangential density[1] is nan, not a finite number");
}

}  // namespace
}  // namespace ffcontact
