// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/estimate/error/contact_error.hpp"
#include "support/cases.hpp"
#include "support/estimates.hpp"
#include "support/refusals.hpp"
#include "support/smooth_problem.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr Tractions all_tractions[] = {Tractions::free, Tractions::fixed,
                                       Tractions::published};

double norm_of_sum(const Estimate<2>& estimate) {
  return estimate.e / estimate.relative;
}

// ---- Property 2.3: the error of an exact pair is zero ---------------------

TEST(Estimate, of_uniform_compression_is_zero_to_rounding) {
  Random random(21);
  Problem problem = body(irregular(5, 4, 40, 40, random), material(13e3, 0.2));
  add_traction(problem, top, {0, -5});
  prescribe(problem, right, 0);
  for (Tractions tractions : all_tractions) {
    const Estimate<2> estimate =
        estimated(problem, solved(problem), sweeps(1, tractions));
    EXPECT_LT(estimate.elastic, 1e-10 * norm_of_sum(estimate));
    EXPECT_LT(std::abs(estimate.contact),
              1e-14 * std::pow(norm_of_sum(estimate), 2));
    EXPECT_TRUE(estimate.admissible) << estimate.reason;
  }
}

TEST(Estimate, of_a_sticking_patch_is_zero_to_rounding) {
  Random random(22);
  const Material steel = material(13e3, 0.2);
  const double h = 1e-3, g = 1e-3;
  Problem problem = body(irregular(5, 4, 40, 40, random), steel);
  add_traction(problem, left, {steel.lambda * h, -steel.G * g});
  add_traction(problem, right, {-steel.lambda * h, steel.G * g});
  clamp(problem, top,
        [=](const Vector2d& x) { return Vector2d(g * x.y(), -h * x.y()); });
  set_friction(problem, 0.5);
  const Estimate<2> estimate = estimated(problem, solved(problem), sweeps(2));
  EXPECT_LT(estimate.elastic, 1e-10 * norm_of_sum(estimate));
  EXPECT_LT(std::abs(estimate.contact),
            1e-14 * std::pow(norm_of_sum(estimate), 2));
}

// ---- what holds for every estimate ----------------------------------------

RC_GTEST_PROP(Estimate, is_admissible_with_tractions_in_the_cone, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  const ContactSolution<2> solution = solved(problem);
  RC_PRE(!solution.pressure.isZero(
      0));  // the next test is about bodies without contact
  const Tractions tractions =
      *rc::gen::element(Tractions::free, Tractions::fixed);
  const Estimate<2> estimate =
      estimated(problem, solution, sweeps(2, tractions));
  RC_ASSERT(estimate.equilibrium.largest() <= 1e-10);
  RC_ASSERT(estimate.cone <= 1e-12);
  RC_ASSERT(estimate.admissible);
  RC_ASSERT(estimate.reason.empty());
}

TEST(Estimate, of_a_body_that_the_loads_lift_off_is_admissible) {
  Problem problem = body(rectangle(4, 3, 4, 3), material(1000, 0.3));
  clamp(problem, top);
  add_body_force(problem, {0, 0.1});
  set_friction(problem, 0.3);
  const ContactSolution<2> solution = solved(problem);
  ASSERT_TRUE(solution.pressure.isZero(0));
  for (Tractions tractions : all_tractions) {
    const Estimate<2> estimate =
        estimated(problem, solution, sweeps(2, tractions));
    EXPECT_TRUE(estimate.admissible) << estimate.reason;
  }
}

RC_GTEST_PROP(Estimate, local_errors_add_up_to_the_whole, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  const Estimate<2> estimate = estimated(problem, solved(problem), sweeps(1));
  RC_ASSERT(
      std::abs(estimate.local.squaredNorm() - std::pow(estimate.relative, 2)) <
      1e-12 * std::pow(estimate.relative, 2));
  const double parts = std::pow(estimate.elastic, 2) + estimate.contact;
  RC_ASSERT(std::abs(std::pow(estimate.e, 2) - parts) < 1e-13 * parts);
  RC_ASSERT(estimate.contact >= -1e-14 * std::pow(norm_of_sum(estimate), 2));
}

RC_GTEST_PROP(Estimate, parts_are_those_of_its_fields, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  const Estimate<2> estimate = estimated(problem, solved(problem), sweeps(1));
  const Matrix3Xd sigma =
      stresses(problem.mesh, problem.hooke, estimate.displacement);
  double elastic = 0, sum = 0;
  for (int t = 0; t < problem.mesh.cell_count(); ++t) {
    const Matrix3d compliance = problem.hooke[t].inverse();
    const SubcellStress<2> constant = sigma.col(t).replicate<1, 9>();
    elastic += energy(corners_of(problem.mesh, t), compliance,
                      estimate.stress[t] - constant);
    sum += energy(corners_of(problem.mesh, t), compliance,
                  estimate.stress[t] + constant);
  }
  RC_ASSERT(std::abs(elastic - std::pow(estimate.elastic, 2)) < 1e-12 * sum);
  RC_ASSERT(std::abs(estimate.e / std::sqrt(sum) - estimate.relative) <
            1e-10 * estimate.relative);
  const double contact =
      contact_error(problem.line, problem.law, estimate.tractions,
                    estimate.displacement)
          .sum();
  RC_ASSERT(std::abs(contact - estimate.contact) < 1e-13 * sum);
}

RC_GTEST_PROP(Estimate, history_never_rises_and_ends_at_the_error, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  const ContactSolution<2> solution = solved(problem);
  const Estimate<2> estimate = estimated(problem, solution, sweeps(4));
  RC_ASSERT(estimate.history.size() == 5u);
  for (int k = 0; k < 4; ++k) {
    RC_ASSERT(estimate.history[k + 1] <= estimate.history[k] * (1 + 1e-13));
    const double again = estimated(problem, solution, sweeps(k)).e;
    RC_ASSERT(std::abs(again - estimate.history[k]) <
              1e-8 * estimate.history[0]);
  }
  RC_ASSERT(estimate.history[4] == estimate.e);
}

/// Where nothing is left to relax, what a sweep changes is rounding, and does not grow.
TEST(Estimate, keeps_equilibrium_however_many_sweeps_are_asked_for) {
  for (const int cells : {1, 2}) {
    Problem problem = body(rectangle(cells, cells, 1, 1), material(1000, 0.3));
    clamp(problem, top, [](const Vector2d&) -> Vector2d {
      return {0.02, -0.01};
    });
    set_friction(problem, 0.3);
    const ContactSolution<2> solution = solved(problem);
    const double enough = estimated(problem, solution, sweeps(40)).e;
    for (const int count : {2, 20, 202, 1000}) {
      const Estimate<2> estimate = estimated(problem, solution, sweeps(count));
      EXPECT_TRUE(estimate.admissible)
          << cells << " cells, " << count << " sweeps: " << estimate.reason;
      EXPECT_LT(estimate.history.size(), 400u);
      EXPECT_NEAR(estimate.e, enough, count > 40 ? 1e-9 * enough : enough);
    }
  }
}

RC_GTEST_PROP(Estimate, does_not_depend_on_the_scale_of_the_loads, ()) {
  const Case c = *random_case(0.5);
  const double factor = *rc::gen::element(1e-4, 20.0, 1e5);
  const auto relative = [](const Case& c) {
    const Problem problem = problem_of(c);
    return estimated(problem, solved(problem), sweeps(2)).relative;
  };
  const double one = relative(c);
  RC_ASSERT(std::abs(relative(scaled(c, factor)) - one) < 1e-7 * one);
}

void assert_the_same_when_rotated(Case c) {
  if (c.support == Support::symmetric_right) c.support = Support::clamped_top;
  const Problem upright = problem_of(c),
                turned = problem_of(rotated(c, *real(-3, 3)));
  const double expected =
      estimated(upright, solved(upright), sweeps(2)).relative;
  RC_ASSERT(std::abs(estimated(turned, solved(turned), sweeps(2)).relative -
                     expected) < 1e-7 * expected);
}

RC_GTEST_PROP(Estimate, of_the_rotated_body_is_the_same, ()) {
  assert_the_same_when_rotated(*random_case(0.5));
}

RC_GTEST_PROP(Estimate, of_the_rotated_body_is_the_same_with_little_friction,
              ()) {
  Case c = *random_case(0.5);
  c.mu = *rc::gen::element(1e-6, 1e-4, 1e-3, 4e-3);
  assert_the_same_when_rotated(c);
}

RC_GTEST_PROP(Estimate, has_an_admissible_displacement, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  const ContactSolution<2> solution = solved(problem);
  const Estimate<2> estimate = estimated(problem, solution, sweeps(0));
  const double scale = solution.displacement.cwiseAbs().maxCoeff();
  RC_ASSERT(contact_components(problem.line, estimate.displacement)
                .row(0)
                .maxCoeff() <= 1e-12 * scale);
  const ElasticSystem system = problem.system();
  for (int dof = 0; dof < system.dof_count(); ++dof)
    if (system.prescribed[dof])
      RC_ASSERT(std::abs(estimate.displacement[dof] -
                         system.prescribed_value[dof]) <= 1e-12 * scale);
}

/// A body that is moved against a wall without stress: what its stresses are of is
/// rounding.
TEST(Estimate, of_a_rigid_motion_is_zero) {
  for (const double angle : {0.0, 0.4, 1.3})
    for (const double size : {1e-6, 1.0, 1e6}) {
      Problem problem =
          body(rotated(rectangle(5, 4, 5 * size, 4 * size), angle),
               material(210e3, 0.3));
      const Vector2d motion = size * Vector2d(0.3, -0.7);
      clamp(problem, top, [&](const Vector2d&) { return motion; });
      problem.law.gap =
          everywhere(problem.line, problem.line.edge_normal(0).dot(motion));
      set_friction(problem, 0.3);
      ContactSolution<2> solution;
      solution.displacement =
          nodal_values(problem.mesh, [&](const Vector2d&) { return motion; });
      // of a solver's rounding
      solution.pressure =
          Matrix2Xd::Constant(2, problem.line.node_count(), -1e-12);
      const Estimate<2> estimate = estimated(problem, solution);
      EXPECT_EQ(estimate.e, 0);
      EXPECT_EQ(estimate.relative, 0);
      EXPECT_EQ(estimate.local.maxCoeff(), 0);
      EXPECT_TRUE(estimate.admissible) << estimate.reason;
    }
}

/// M'_h lets one node penetrate where its neighbours keep clear: u has no stress, but
/// u_hat, which is lifted there, has.
TEST(Estimate, of_a_body_without_stress_that_penetrates_is_that_of_u_hat) {
  Problem problem = body(rectangle(4, 2, 4, 2), material(1000, 0.3));
  clamp(problem, top);
  problem.law.multiplier = Multiplier::pressure;
  problem.law.gap = everywhere(problem.line, 1);
  problem.law.gap[2] = -0.1;
  const ContactSolution<2> solution = solved(problem);
  ASSERT_LT(solution.displacement.cwiseAbs().maxCoeff(), 1e-12);
  for (const double slip_bound : {0.0, 1.0}) {
    if (slip_bound > 0)
      problem.law.slip_bound = everywhere(problem.line, slip_bound);
    const Estimate<2> estimate = estimated(problem, solution);
    EXPECT_GT(estimate.e, 1);
    EXPECT_NEAR(estimate.relative, 1, 1e-12);  // sigma_hat = 0
    EXPECT_TRUE(estimate.admissible) << estimate.reason;
    EXPECT_EQ(estimate.tractions.normal.cwiseAbs().maxCoeff(), 0);
  }
}

/// Small stresses beside a large rigid motion are judged by what rounding of that motion
/// leaves of them.
TEST(Estimate, of_small_stresses_beside_a_large_motion) {
  const auto estimate_of = [](double motion) {
    Problem problem = body(rectangle(5, 4, 5, 4), material(1000, 0.3));
    clamp(problem, top, [&](const Vector2d& x) -> Vector2d {
      return {motion, -1e-4 * x.x() - motion};
    });
    problem.law.gap = everywhere(problem.line, motion);
    set_friction(problem, 0.3);
    problem.law.previous = everywhere(problem.line, motion);
    return estimated(problem, solved(problem));
  };
  const Estimate<2> still = estimate_of(0);
  for (const double motion : {1.0, 1e3, 1e5}) {
    const Estimate<2> estimate = estimate_of(motion);
    EXPECT_TRUE(estimate.admissible) << motion << ": " << estimate.reason;
    EXPECT_NEAR(estimate.relative, still.relative, 1e-3 * still.relative);
  }
}

TEST(Estimate, does_not_depend_on_the_units) {
  const auto relative = [](const Mesh& mesh, double stiffness,
                           double slip_bound) {
    Problem problem = body(mesh, material(13e3 * stiffness, 0.2));
    add_traction(problem, left, {10 * stiffness, 0});
    clamp(problem, top);
    prescribe(problem, right, 0);
    set_friction(problem, 0.5);
    if (slip_bound > 0)
      problem.law.slip_bound = everywhere(problem.line, slip_bound * stiffness);
    return estimated(problem, solved(problem)).relative;
  };
  for (const double slip_bound : {0.0, 2.0}) {
    const double expected = relative(rectangle(16, 8, 80, 40), 1, slip_bound);
    for (const double length : {1e-9, 1e-3, 1e6})
      for (const double stiffness : {1e-9, 1e3, 1e6}) {
        const double scaled = relative(
            rectangle(16, 8, 80 * length, 40 * length), stiffness, slip_bound);
        EXPECT_NEAR(scaled / expected, 1, 1e-8)
            << "length " << length << ", stiffness " << stiffness;
      }
  }
}

/// A prescribed displacement that penetrates cannot be lowered: u is not admissible, and
/// the estimate says so.
TEST(Estimate, says_where_u_penetrates) {
  for (const Multiplier multiplier :
       {Multiplier::force, Multiplier::pressure}) {
    Problem problem = body(rectangle(4, 4, 1, 1), material(1000, 0.3));
    clamp(problem, right);
    clamp(problem, left);
    add_traction(problem, top, {0, -10});
    problem.law.multiplier = multiplier;
    ContactSolution<2> solution = solved(problem);
    EXPECT_TRUE(estimated(problem, solution).admissible);
    problem.law.gap = everywhere(problem.line, 0);
    // the foundation now reaches into a clamped corner
    problem.law.gap[problem.line.node_count() - 1] = -1e-6;
    const Estimate<2> estimate = estimated(problem, solution);
    EXPECT_FALSE(estimate.admissible);
    EXPECT_GT(estimate.penetration, 1e-7);
    EXPECT_TRUE(says(estimate.reason, "u penetrates by ") &&
                says(estimate.reason, "at (1, 0), where displacements"))
        << estimate.reason;
  }
}

// ---- against an exact solution --------------------------------------------

TEST(Estimate, of_the_smooth_problem_in_contact_is_a_tight_bound) {
  const Manufactured exact = smooth_solution(0.3);
  for (int n : {8, 16, 24}) {
    const Problem problem = with_contact(exact, rectangle(n, n, 2, 2));
    const ContactSolution<2> solution = solved(problem);
    const double error = error_of(exact, problem, solution.displacement),
                 tightness[] = {1.16, 1.04, 1.02};
    for (int k = 1; k <= 3; ++k) {
      const double e = estimated(problem, solution, sweeps(k)).e;
      EXPECT_GE(e, error);
      EXPECT_LE(e, tightness[k - 1] * error) << "n " << n << ", sweeps " << k;
    }
  }
}

TEST(Estimate, of_a_nearly_incompressible_body_stays_a_bound) {
  const Manufactured exact = smooth_solution(0.49);
  const Problem problem = with_contact(exact, rectangle(8, 8, 2, 2));
  const ContactSolution<2> solution = solved(problem);
  const double error = error_of(exact, problem, solution.displacement),
               e = estimated(problem, solution, sweeps(4)).e;
  EXPECT_GE(e, error);
  EXPECT_LE(e, 1.5 * error);
}

RC_GTEST_PROP(Estimate, bounds_both_errors_together_without_friction,
              (Random random)) {
  // its data are those of the discrete problem
  const Manufactured exact = cubic_solution(*real(0, 0.45));
  Problem problem = loaded_in_contact(
      exact, irregular(*rc::gen::inRange(2, 7), 4, 2, 2, random));
  problem.law.multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  const ContactSolution<2> solution = solved(problem);
  RC_ASSERT(solution.status == ContactStatus::converged);
  const Estimate<2> estimate =
      estimated(problem, solution, sweeps(*rc::gen::inRange(0, 4)));
  RC_ASSERT(estimate.admissible);
  const double of_stress = distance(exact, problem.mesh, estimate.stress);
  const double of_displacement =
      error_of(exact, problem, estimate.displacement);
  // (2.20)
  RC_ASSERT(std::hypot(of_stress, of_displacement) <= estimate.e * (1 + 1e-10));
}

// ---- the published meshes -------------------------------------------------

double published_percentage(const Problem& problem, int count) {
  const Estimate<2> estimate =
      estimated(problem, solved(problem), sweeps(count, Tractions::published));
  EXPECT_LT(estimate.equilibrium.largest(), 1e-10);
  return 100 * estimate.relative;
}

TEST(Estimate,
     of_the_published_meshes_after_one_sweep_with_correction_41_alone) {
  EXPECT_NEAR(published_percentage(example_1(Multiplier::force), 1) / 8.22, 1,
              0.03);
  EXPECT_NEAR(published_percentage(example_2(Multiplier::force, 0.2), 1) / 1.21,
              1, 0.03);
  EXPECT_NEAR(published_percentage(example_2(Multiplier::force, 0.3), 1) / 1.39,
              1, 0.03);
  EXPECT_NEAR(published_percentage(example_2(Multiplier::force, 0.4), 1) / 1.46,
              1, 0.03);
}

TEST(Estimate, of_the_published_mesh_without_sweeps) {
  EXPECT_NEAR(published_percentage(example_2(Multiplier::force, 0.4), 0) / 3.0,
              1, 0.03);
}

TEST(Estimate, with_tractions_in_the_cone_is_sharper_than_published) {
  const auto percentage = [](const Problem& problem) {
    return 100 * estimated(problem, solved(problem), sweeps(2)).relative;
  };
  // published 9.74
  EXPECT_NEAR(percentage(example_1(Multiplier::force)) / 7.93, 1, 0.03);
  EXPECT_NEAR(percentage(example_2(Multiplier::force, 0.3)) / 1.20, 1,
              0.03);  // 1.46
  EXPECT_NEAR(percentage(example_2(Multiplier::force, 0.4)) / 1.17, 1,
              0.03);  // 1.50
}

TEST(Estimate,
     effectivity_on_the_meshes_of_table_1_is_at_most_120_after_three_sweeps) {
  const std::pair<double, double> exact[] = {
      {0.2, 0.93},
      {0.4, 1.02},
      {0.6, 1.02},
      {0.8, 1.02}};  // mu, exact error in %
  for (const auto& [mu, percentage] : exact) {
    const Problem problem = example_2(Multiplier::force, mu);
    EXPECT_LE(100 * estimated(problem, solved(problem), sweeps(3)).relative,
              1.20 * percentage)
        << "mu " << mu;
  }
}

TEST(Estimate, of_example_2_falls_with_the_mesh_for_both_methods) {
  for (Multiplier multiplier : {Multiplier::force, Multiplier::pressure}) {
    const auto relative = [&](int cells) {
      const Problem problem = example_2(multiplier, 0.6, cells);
      return estimated(problem, solved(problem), sweeps(2)).relative;
    };
    EXPECT_LT(relative(16), 0.65 * relative(8));
  }
}

// ---- the numerical construction of [CHH01, 4.2.2] -------------------------

TEST(Estimate, by_polynomials_is_lower_and_says_that_it_is_not_admissible) {
  const Problem problem = example_1(Multiplier::force);
  const ContactSolution<2> solution = solved(problem);
  EstimateSettings<2> settings = sweeps(2);
  const Estimate<2> composite = estimated(problem, solution, settings);
  settings.construction = Construction::polynomial;
  const Estimate<2> polynomial = estimated(problem, solution, settings);
  EXPECT_LT(polynomial.e, composite.e);
  EXPECT_GT(polynomial.e, 0.8 * composite.e);
  EXPECT_EQ(polynomial.history, composite.history);
  EXPECT_TRUE(composite.admissible);
  EXPECT_FALSE(polynomial.admissible);
  EXPECT_TRUE(
      says(polynomial.reason,
           "the polynomial construction is in equilibrium in the mean only"));
  EXPECT_NEAR(polynomial.local.norm(), polynomial.relative, 1e-12);
  RecordProperty("ratio", std::to_string(polynomial.e / composite.e));
}

// ---- progress -------------------------------------------------------------

TEST(Estimate, tells_of_every_sweep) {
  const Problem problem = example_1(Multiplier::force, 8);
  std::vector<Progress> told;
  EstimateSettings<2> settings = sweeps(3);
  settings.report = [&](const Progress& p) { told.push_back(p); };
  const Estimate<2> estimate = estimated(problem, solved(problem), settings);
  ASSERT_EQ(told.size(), 4u);
  EXPECT_STREQ(told[0].phase, "admissible fields");
  for (int k = 1; k <= 3; ++k) {
    EXPECT_STREQ(told[k].phase, "relaxation");
    EXPECT_EQ(told[k].step, k);
    EXPECT_NEAR(told[k].value / estimate.history[k], 1, 1e-6);
  }
}

// ---- checks and refusals --------------------------------------------------

TEST(Estimate, outside_the_cone_says_why_it_is_not_admissible) {
  const Problem problem = example_2(Multiplier::force, 0.2);
  const Estimate<2> estimate =
      estimated(problem, solved(problem), sweeps(1, Tractions::published));
  if (estimate.cone <= 1e-12)
    GTEST_SKIP() << "every edge could be mended by (4.1)";
  EXPECT_FALSE(estimate.admissible);
  EXPECT_TRUE(
      says(estimate.reason, "contact tractions leave the friction cone by "));
  EXPECT_TRUE(says(estimate.reason,
                   "(4.1) cannot mend " +
                       std::to_string(estimate.unmended.size()) + " edges"));
  EXPECT_FALSE(estimate.unmended.empty());
}

TEST(Estimate, refuses_what_does_not_fit) {
  const Problem problem = example_1(Multiplier::force, 2);
  const ContactSolution<2> solution = solved(problem);
  const auto refusal_of = [&](auto spoil) {
    SolvedBody<2> body = solved_body(problem, solution);
    EstimateSettings<2> settings;
    spoil(body, settings);
    return refusal([&] {
      estimate_error(topology_of(problem.mesh), problem.line, problem.system(),
                     body, settings);
    });
  };
  EXPECT_EQ(refusal_of([](SolvedBody<2>&, EstimateSettings<2>&) {}),
            "accepted");
  EXPECT_TRUE(says(refusal_of([](SolvedBody<2>& b, EstimateSettings<2>&) {
                     b.displacement[3] = std::nan("");
                   }),
                   "u[3] is nan"));
  EXPECT_TRUE(says(refusal_of([](SolvedBody<2>& b, EstimateSettings<2>&) {
                     b.displacement.resize(7);
                   }),
                   "u has 7 values"));
  EXPECT_TRUE(says(refusal_of([](SolvedBody<2>& b, EstimateSettings<2>&) {
                     b.multipliers.resize(2, 4);
                   }),
                   "4 values where 5"));
  EXPECT_TRUE(says(refusal_of([](SolvedBody<2>& b, EstimateSettings<2>&) {
                     b.law.friction[1] = -1;
                   }),
                   "friction must be finite"));
  EXPECT_TRUE(says(refusal_of([](SolvedBody<2>& b, EstimateSettings<2>&) {
                     b.hooke[2].setZero();
                   }),
                   "triangle 2 is not symmetric"));
  EXPECT_TRUE(says(refusal_of([](SolvedBody<2>&, EstimateSettings<2>& s) {
                     s.relaxation.steps = -1;
                   }),
                   "sweeps must not be negative"));
  EXPECT_TRUE(says(refusal_of([](SolvedBody<2>& b, EstimateSettings<2>&) {
                     b.neumann *= 2;
                   }),
                   "do not balance the stresses"));
}

}  // namespace
}  // namespace ffcontact
