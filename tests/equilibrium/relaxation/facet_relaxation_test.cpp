// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/relaxation/facet_relaxation.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <set>

#include "ffcontact/contact/law/cone_correction.hpp"
#include "ffcontact/estimate/error/contact_edges.hpp"
#include "ffcontact/estimate/error/contact_error.hpp"
#include "support/cases.hpp"
#include "support/estimates.hpp"
#include "support/smooth_problem.hpp"
#include "support/threads.hpp"

namespace ffcontact {
namespace {

using namespace test;

std::vector<double> relax(Equilibrated& fields, std::optional<int> steps,
                          double tightness = 0) {
  return relax_facets<2>({fields.difference()}, {steps, tightness},
                         fields.moments);
}

/// A problem with tractions in the cone (example 2 with friction enough to stick, after
/// correction (4.1)), which are free.
struct InCone {
  Problem problem = example_2(Multiplier::force, 0.6, 8);
  ContactSolution<2> solution = solved(problem);
  ConeCorrection correction =
      correct_to_cone(problem.line, problem.law,
                      edge_densities(problem.line, solution.pressure));
  Equilibrated fields =
      equilibrated(problem, solution.displacement, correction.densities);
  ContactDensities densities = correction.densities;

  std::vector<double> relax(int steps) {
    const FacetSetting<2> setting{
        fields.difference(),
        contact_edges(problem.line, problem.law, solution.displacement,
                      densities, fields.boundary)};
    const std::vector<double> falls =
        relax_facets<2>(setting, {steps}, fields.moments);
    put_tractions(setting.contact, fields.moments, densities);
    fields.boundary = boundary_tractions(
        problem.mesh, problem.edges, prescribed_dofs(problem.A),
        problem.neumann, problem.line, densities);
    return falls;
  }
};

RC_GTEST_PROP(FacetRelaxation, keeps_equilibrium_and_boundary_tractions, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  Equilibrated fields = equilibrated(problem, solved(problem));
  relax(fields, 3);
  RC_ASSERT(
      defect_of(problem, fields, admissible_stress(problem, fields)).largest() <
      1e-10);
}

RC_GTEST_PROP(FacetRelaxation, falls_in_every_step_by_what_the_energy_falls,
              ()) {
  const Problem problem = problem_of(*random_case(0.5));
  Equilibrated fields = equilibrated(problem, solved(problem));
  double before = elastic_square(problem, fields);
  const double scale = before;
  for (int step = 0; step < 3; ++step) {
    const std::vector<double> falls = relax(fields, 1);
    const double after = elastic_square(problem, fields);
    RC_ASSERT(falls.size() == 1u);
    RC_ASSERT(falls[0] >= -1e-13 * scale);
    RC_ASSERT(std::abs(before - after - falls[0]) < 1e-10 * scale);
    before = after;
  }
}

RC_GTEST_PROP(FacetRelaxation, falls_of_several_steps_add_up, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  Equilibrated fields = equilibrated(problem, solved(problem));
  const double before = elastic_square(problem, fields);
  double sum = 0;
  for (double fall : relax(fields, 5)) sum += fall;
  RC_ASSERT(std::abs(before - elastic_square(problem, fields) - sum) <
            1e-10 * before);
}

/// Runs a relaxation with one thread and with two.
template <class Fields, class Relax>
void with_one_and_two_threads(Fields& one, Fields& two, Relax&& relax) {
  on_threads(2, [&] { relax(two); });
  on_threads(1, [&] { relax(one); });
}

TEST(FacetRelaxation, does_not_depend_on_the_number_of_threads) {
  Random random(31);
  Problem problem = body(irregular(8, 6, 8, 6, random), material(1000, 0.3));
  add_traction(problem, left, {1, -2});
  clamp(problem, top);
  set_friction(problem, 0.3);
  Equilibrated one = equilibrated(problem, solved(problem)), two = one;
  with_one_and_two_threads(one, two,
                           [&](Equilibrated& fields) { relax(fields, 3); });
  EXPECT_EQ(one.moments, two.moments);
}

TEST(FacetRelaxation,
     with_free_tractions_does_not_depend_on_the_number_of_threads) {
  InCone one, two;
  with_one_and_two_threads(one, two, [](InCone& c) { c.relax(2); });
  EXPECT_EQ(one.fields.moments, two.fields.moments);
  EXPECT_EQ(one.densities.normal, two.densities.normal);
  EXPECT_EQ(one.densities.tangential, two.densities.tangential);
}

TEST(FacetRelaxation,
     with_free_tractions_stays_in_the_cone_and_in_equilibrium) {
  InCone c;
  ASSERT_TRUE(c.correction.uncorrected.empty());
  for (int step = 0; step < 4; ++step) {
    c.relax(1);
    EXPECT_LE(cone_defect(c.problem.line, c.problem.law, c.densities), 1e-12);
    EXPECT_LT(
        defect_of(c.problem, c.fields, admissible_stress(c.problem, c.fields))
            .largest(),
        1e-10);
  }
}

TEST(FacetRelaxation, with_free_tractions_falls_by_what_the_whole_error_falls) {
  InCone c;
  const auto square = [&] {
    return elastic_square(c.problem, c.fields) +
           contact_error(c.problem.line, c.problem.law, c.densities,
                         c.solution.displacement)
               .sum();
  };
  const double scale = square();
  double before = scale;
  for (int step = 0; step < 4; ++step) {
    const std::vector<double> falls = c.relax(1);
    ASSERT_EQ(falls.size(), 1u);
    EXPECT_GE(falls[0], 0);
    const double after = square();
    EXPECT_NEAR(before - after, falls[0], 1e-10 * scale);
    before = after;
  }
  EXPECT_LT(before, 0.2 * scale);
}

/// Two triangles on rollers leave the descent hardly more than one direction, of which
/// rounding is all that is left from step to step.
RC_GTEST_PROP(FacetRelaxation, keeps_balance_for_hundreds_of_steps, ()) {
  Problem problem =
      body(rectangle(1, 1, *real(1, 2), 1), material(1000, *real(-0.4, 0.4)));
  prescribe(problem, left, 0);
  prescribe(problem, top, 1);
  add_body_force(problem, {*real(-1, 1), *real(-1, 1)});
  const Estimate<2> estimate = estimated(problem, solved(problem), sweeps(200));
  RC_ASSERT(estimate.equilibrium.largest() < 1e-12);
}

/// |sigma_hat - C eps(u_h)| / |u - u_h| before the first and after every step.
std::vector<double> effectivities(const Manufactured& exact, int cells,
                                  int steps) {
  const Problem problem = without_contact(exact, rectangle(cells, cells, 2, 2));
  const VectorXd u = solved_without_contact(problem);
  Equilibrated fields =
      equilibrated(problem, u, {Matrix2Xd(2, 0), Matrix2Xd(2, 0)});
  const double error = error_of(exact, problem, u);
  double square = elastic_square(problem, fields);
  std::vector<double> result{std::sqrt(square) / error};
  for (double fall : relax(fields, steps))
    result.push_back(std::sqrt(square -= fall) / error);
  return result;
}

TEST(FacetRelaxation,
     makes_the_bound_of_a_smooth_problem_tight_in_three_steps_on_every_mesh) {
  for (int cells : {8, 16, 24}) {
    const std::vector<double> effectivity =
        effectivities(smooth_solution(0.3), cells, 3);
    EXPECT_LE(effectivity[1], 1.08) << "cells " << cells;
    EXPECT_LE(effectivity[2], 1.03) << "cells " << cells;
    EXPECT_LE(effectivity[3], 1.02) << "cells " << cells;
    EXPECT_GE(effectivity[3], 1) << "cells " << cells;
  }
}

TEST(FacetRelaxation, makes_the_bound_of_a_nearly_incompressible_body_tight) {
  const std::vector<double> effectivity =
      effectivities(smooth_solution(0.49), 16, 4);
  EXPECT_LE(effectivity[4], 1.15);
  EXPECT_GE(effectivity[4], 1);
}

TEST(FacetRelaxation,
     makes_the_bound_tight_in_four_steps_on_a_fine_mesh_up_to_nu_0499) {
  for (const auto& [nu, tightness] :
       {std::make_pair(0.49, 1.15), std::make_pair(0.499, 1.3)}) {
    const std::vector<double> effectivity =
        effectivities(smooth_solution(nu), 32, 4);
    RecordProperty("nu_" + std::to_string(nu), std::to_string(effectivity[4]));
    EXPECT_LE(effectivity[4], tightness) << "nu " << nu;
    EXPECT_GE(effectivity[4], 1) << "nu " << nu;
  }
}

TEST(FacetRelaxation,
     on_a_coarse_mesh_of_an_incompressible_body_stays_a_bound) {
  for (const auto& [nu, tightness] :
       {std::make_pair(0.49, 1.4), std::make_pair(0.499, 2.5)}) {
    const std::vector<double> effectivity =
        effectivities(smooth_solution(nu), 8, 4);
    RecordProperty("nu_" + std::to_string(nu), std::to_string(effectivity[4]));
    EXPECT_LE(effectivity[4], tightness) << "nu " << nu;
    EXPECT_GE(effectivity[4], 1) << "nu " << nu;
  }
}

TEST(FacetRelaxation,
     stops_when_a_step_lowers_the_error_by_less_than_its_tightness) {
  const Problem problem = example_2(Multiplier::force, 0.6, 8);
  const Equilibrated fields = equilibrated(problem, solved(problem));
  Equilibrated all = fields, some = fields;
  const std::vector<double> falls = relax(all, 10);
  ASSERT_EQ(falls.size(), 10u);
  double square = elastic_square(problem, fields);
  std::size_t expected = 0;
  // the first step after which e fell by less than 2 %
  for (; expected < 10; ++expected) {
    const double next = square - falls[expected];
    const bool enough = std::sqrt(next) > 0.98 * std::sqrt(square);
    square = next;
    if (enough) break;
  }
  EXPECT_EQ(relax(some, 10, 0.02).size(), expected + 1);
}

TEST(FacetRelaxation, without_a_number_goes_on_after_a_second_step_of_a_sixth) {
  std::set<std::size_t> counts;
  for (double nu : {0.3, 0.45, 0.49, 0.499}) {
    const Problem problem =
        without_contact(smooth_solution(nu), rectangle(8, 8, 2, 2));
    Equilibrated all = equilibrated(problem, solved_without_contact(problem),
                                    {Matrix2Xd(2, 0), Matrix2Xd(2, 0)}),
                 some = all;
    std::vector<double> e{std::sqrt(elastic_square(problem, all))};
    for (double fall : relax(all, 12))
      e.push_back(std::sqrt(e.back() * e.back() - fall));
    std::size_t last = 2;
    double worth = 0.16;
    for (; last < 12 && e[last] < (1 - worth) * e[last - 1]; ++last)
      worth = 0.02;
    EXPECT_EQ(relax(some, std::nullopt).size(), last) << "nu " << nu;
    counts.insert(last);
  }
  EXPECT_GT(counts.size(), 2u);
}

TEST(FacetRelaxation, without_steps_changes_nothing) {
  const Problem problem = example_1(Multiplier::force, 4);
  Equilibrated fields = equilibrated(problem, solved(problem));
  const EdgeMoments before = fields.moments;
  EXPECT_TRUE(relax(fields, 0).empty());
  EXPECT_EQ(fields.moments, before);
}

}  // namespace
}  // namespace ffcontact
