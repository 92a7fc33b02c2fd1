// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/linear/minimum/nonnegative_least_squares.hpp"
#include "support/cases.hpp"
#include "support/refusals.hpp"
#include "support/told.hpp"

namespace ffcontact {
namespace {

using namespace test;

bool accepted(const ContactSolution<2>& solution) {
  return solution.accepted(ContactSettings{});
}

int count(const ContactSolution<2>& solution, ContactState state) {
  return static_cast<int>(
      std::count(solution.state.begin(), solution.state.end(), state));
}

std::string refusal_of(const Problem& problem) {
  return refusal([&] { solved(problem); });
}

class BothMultipliers : public testing::TestWithParam<Multiplier> {};
INSTANTIATE_TEST_SUITE_P(ContactSolution, BothMultipliers,
                         testing::Values(Multiplier::force,
                                         Multiplier::pressure),
                         [](const auto& info) {
                           return info.param == Multiplier::force ? "force"
                                                                  : "pressure";
                         });

// ---- the published examples -----------------------------------------------

TEST_P(BothMultipliers,
       example_1_is_solved_and_slips_everywhere_but_on_the_symmetry_line) {
  const ContactSolution<2> solution = solved(example_1(GetParam()));
  EXPECT_TRUE(accepted(solution)) << in_words(solution.status);
  const int open = count(solution, ContactState::open),
            sliding = count(solution, ContactState::slip_forward);
  EXPECT_GE(open + sliding, 32);
  // separation at the left
  for (int i = 0; i < open; ++i)
    EXPECT_EQ(solution.state[i], ContactState::open);
}

TEST_P(BothMultipliers, example_2_is_solved_for_every_friction_of_table_1) {
  for (double mu : {0.2, 0.3, 0.4, 0.6, 0.8}) {
    const ContactSolution<2> solution = solved(example_2(GetParam(), mu));
    EXPECT_TRUE(accepted(solution))
        << "mu " << mu << ": " << in_words(solution.status);
  }
}

TEST(ContactSolution, example_1_has_the_nodal_forces_of_an_independent_code) {
  const ContactSolution<2> solution = solved(example_1(Multiplier::force));
  const double compression[] = {1.935285757411, 10.24738005932, 10.07714695952,
                                9.208734186423, 8.115072544281};
  const int first = count(solution, ContactState::open);
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(-solution.force(0, first + k) / compression[k], 1, 1e-8);
  EXPECT_NEAR(solution.displacement[0] / 2.908484511972e-2, 1, 1e-8);
}

TEST(ContactSolution, example_2_sticks_at_every_node_from_friction_of_04_on) {
  const VectorXd reference =
      solved(example_2(Multiplier::force, 0.4)).displacement;
  for (double mu : {0.4, 0.6, 0.8}) {
    const ContactSolution<2> solution =
        solved(example_2(Multiplier::force, mu));
    EXPECT_EQ(count(solution, ContactState::stick), 17);
    EXPECT_LT(relative_difference(solution.displacement, reference), 1e-12);
  }
}

// ---- benchmarks ---------------------------------------------------------------------------------

TEST_P(BothMultipliers,
       block_with_three_zones_opens_slips_and_sticks_as_published) {
  Problem problem = block_with_three_zones(32);
  problem.law.multiplier = GetParam();
  const ContactSolution<2> solution = solved(problem);
  EXPECT_TRUE(accepted(solution));
  // less the force on the held corner
  EXPECT_NEAR(-solution.force.row(0).head(32).sum(), 2000, 2000 * 0.03);
  EXPECT_NEAR(solution.force.row(1).head(32).sum(), -1405.4, 1405.4 * 0.02);
  const double published[] = {28.6e-3, 27.2e-3, 22.8e-3, 19.8e-3, 15.0e-3};
  const int node[] = {0, 1, 4, 6, 9};  // x = 0, 1.25, 5, 7.5, 11.25
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(solution.displacement[2 * node[k]], published[k],
                0.05 * published[k]);
  EXPECT_EQ(solution.state[1], ContactState::open);  // open for x < 3.36
  EXPECT_EQ(solution.state[4],
            ContactState::slip_forward);  // slip up to x = 29.77
  EXPECT_EQ(solution.state[22], ContactState::slip_forward);
  EXPECT_EQ(solution.state[26], ContactState::stick);
}

/// A pad 40 x 20 pressed by 12000 N/mm and pushed by a part of mu N = 3600 N/mm; a weak
/// spring holds it.
ContactSolution<2> pushed_pad(double part, double spring) {
  Problem problem = body(rectangle(16, 8, 40, 20), material(200e3, 0.3));
  add_traction(problem, top, {0, -300});
  add_body_force(problem, {part * 3600 / 800, 0});
  for (int v = 0; v < problem.mesh.vertex_count(); ++v)
    problem.A.coeffRef(2 * v, 2 * v) += spring / problem.mesh.vertex_count();
  set_friction(problem, 0.3);
  return solved(problem);
}

TEST(ContactSolution,
     a_pad_pushed_by_less_than_friction_sticks_and_by_more_slides) {
  const double spring = 10;  // N/mm per mm
  const ContactSolution<2> sticking = pushed_pad(0.99, spring),
                           sliding = pushed_pad(1.01, spring);
  EXPECT_TRUE(accepted(sticking));
  EXPECT_TRUE(accepted(sliding));
  EXPECT_GT(count(sticking, ContactState::stick), 0);
  EXPECT_NEAR(sticking.force.row(1).sum(), -0.99 * 3600, 10);
  EXPECT_EQ(count(sliding, ContactState::slip_forward), 17);
  EXPECT_NEAR(sliding.force.row(1).sum(), -3600, 1e-8);
  // the spring takes what friction leaves
  EXPECT_NEAR(sliding.displacement[0], 36 / spring, 0.2);
}

TEST_P(BothMultipliers,
       a_block_dragged_along_by_its_side_slides_with_the_friction_of_its_load) {
  Problem problem = body(rectangle(8, 8, 40, 40), material(13e3, 0.2));
  add_traction(problem, top, {0, -5});
  prescribe(problem, right, 0,
            [](const Vector2d&) { return Vector2d(0.5, 0); });
  set_friction(problem, 0.3);
  problem.law.multiplier = GetParam();
  const ContactSolution<2> solution = solved(problem);
  EXPECT_TRUE(accepted(solution))
      << in_words(solution.status) << ", complementarity "
      << solution.complementarity;
  EXPECT_EQ(count(solution, ContactState::stick), 0);
  EXPECT_NEAR(solution.force.row(1).sum(), -0.3 * 200, 1e-8);
}

// ---- patch tests: linear displacements that P1 elements hold exactly (benchmarks.md B4)
// ---------

/// A patch test, solved.
template <class Patch>
struct SolvedPatch {
  Patch patch;
  Problem problem;
  ContactSolution<2> solution;
  SolvedPatch(const Patch& p, const Mesh& mesh, Multiplier multiplier)
      : patch(p), problem(p.problem(mesh)) {
    problem.law.multiplier = multiplier;
    solve();
  }
  void solve() { solution = solved(problem); }
  /// Largest error of u, relative to the largest displacement.
  double error() const {
    const VectorXd exact = nodal_values(
        problem.mesh, [this](const Vector2d& x) { return patch.exact(x); });
    return relative_difference(solution.displacement, exact);
  }
};

/// u = (0.1 - e x + g y, 0) with g = mu lambda e / G: slips everywhere under the pressure
/// lambda e.
struct SlipPatch {
  Material material = test::material(13e3, 0.2);
  double mu = 0.5, e = 1e-3;
  double pressure() const { return material.lambda * e; }
  Vector2d exact(const Vector2d& x) const {
    return {0.1 - e * x.x() + mu * pressure() / material.G * x.y(), 0};
  }
  Problem problem(const Mesh& mesh) const {
    Problem problem = body(mesh, material);
    add_traction(problem, left,
                 {(material.lambda + 2 * material.G) * e, -mu * pressure()});
    add_traction(problem, top, {mu * pressure(), -pressure()});
    clamp(problem, right, [this](const Vector2d& x) { return exact(x); });
    set_friction(problem, mu);
    return problem;
  }
};

/// u = (g y, -h y): the bottom stays where it is under the pressure (lambda + 2 G) h and
/// the shear G g.
struct StickPatch {
  Material material = test::material(13e3, 0.2);
  double h = 1e-3, g = 1.33e-3;
  double pressure() const { return (material.lambda + 2 * material.G) * h; }
  double shear() const { return material.G * g; }
  Vector2d exact(const Vector2d& x) const { return {g * x.y(), -h * x.y()}; }
  Problem problem(const Mesh& mesh) const {
    Problem problem = body(mesh, material);
    add_traction(problem, left, {material.lambda * h, -shear()});
    add_traction(problem, right, {-material.lambda * h, shear()});
    clamp(problem, top, [this](const Vector2d& x) { return exact(x); });
    set_friction(problem, 0.5);
    return problem;
  }
};

Mesh irregular_block() {
  Random random(11);
  return irregular(5, 4, 40, 40, random);
}

TEST_P(BothMultipliers, slip_patch_is_exact_on_an_irregular_mesh) {
  const SolvedPatch<SlipPatch> s({}, irregular_block(), GetParam());
  EXPECT_TRUE(accepted(s.solution));
  EXPECT_LT(s.error(), 1e-10);
  // the last node is held
  EXPECT_GE(count(s.solution, ContactState::slip_forward),
            s.problem.line.node_count() - 1);
}

TEST(ContactSolution, slip_patch_has_the_pressures_361111_and_180556) {
  const SolvedPatch<SlipPatch> s({}, irregular_block(), Multiplier::force);
  // held in both directions: no equation determines its force
  const int last = s.problem.line.node_count() - 1;
  const VectorXd weight =
      contact_mass(s.problem.line) * everywhere(s.problem.line, 1);
  for (int i = 0; i < last; ++i) {
    EXPECT_NEAR(s.solution.force(0, i) / weight[i], -3.611111111111111, 1e-9);
    EXPECT_NEAR(s.solution.force(1, i) / weight[i], -1.805555555555556, 1e-9);
  }
}

TEST_P(BothMultipliers, stick_patch_is_exact_on_an_irregular_mesh) {
  const SolvedPatch<StickPatch> s({}, irregular_block(), GetParam());
  EXPECT_TRUE(accepted(s.solution));
  EXPECT_LT(s.error(), 1e-10);
  EXPECT_EQ(count(s.solution, ContactState::stick),
            s.problem.line.node_count());
  const VectorXd ones = everywhere(s.problem.line, 1);
  EXPECT_LT(relative_difference(s.solution.pressure.row(0).transpose(),
                                -s.patch.pressure() * ones),
            1e-10);
  EXPECT_LT(relative_difference(s.solution.pressure.row(1).transpose(),
                                -s.patch.shear() * ones),
            1e-10);
}

/// Nothing determines the pressure at a vertex that cannot move: it goes on as beside it,
/// also where Newton starts from an open node there, as good an answer but for pressures
/// that alternate.
TEST_P(BothMultipliers, stick_patch_has_its_pressure_up_to_a_clamped_side) {
  const StickPatch patch;
  Problem problem = patch.problem(irregular_block());
  problem.law.multiplier = GetParam();
  clamp(problem, right, [&](const Vector2d& x) { return patch.exact(x); });
  const int nodes = problem.line.node_count();
  ContactSettings settings;
  for (const int open : {-1, nodes - 1, nodes - 2}) {
    settings.initial_state.assign(nodes, ContactState::stick);
    if (open >= 0) settings.initial_state[open] = ContactState::open;
    const ContactSolution<2> solution = solved(problem, settings);
    ASSERT_TRUE(accepted(solution)) << open;
    const Eigen::RowVectorXd ones = Eigen::RowVectorXd::Ones(nodes);
    EXPECT_LT(
        relative_difference(solution.pressure.row(0), -patch.pressure() * ones),
        1e-10)
        << open;
    EXPECT_LT(
        relative_difference(solution.pressure.row(1), -patch.shear() * ones),
        1e-10)
        << open;
  }
}

/// Where all nodes stick the law is obeyed to the bit, and the displacement of the body
/// to rounding.
TEST_P(BothMultipliers, more_accuracy_than_rounding_allows_is_not_reached) {
  const SolvedPatch<StickPatch> s({}, irregular_block(), GetParam());
  ContactSettings settings;
  settings.tolerance = 1e-30;
  EXPECT_EQ(solved(s.problem, settings).status, ContactStatus::inaccurate);
}

TEST_P(BothMultipliers, stick_patch_slips_beyond_the_threshold) {
  StickPatch patch;
  patch.g = 1.34e-3;
  const SolvedPatch<StickPatch> s(patch, rectangle(4, 4, 40, 40), GetParam());
  EXPECT_TRUE(accepted(s.solution));
  EXPECT_GT(count(s.solution, ContactState::slip_forward), 0);
}

TEST(ContactSolution, patch_tests_see_a_spoiled_load) {
  SolvedPatch<SlipPatch> s({}, rectangle(4, 4, 40, 40), Multiplier::force);
  ASSERT_LT(s.error(), 1e-10);
  s.problem.b[0] += 1e-3;
  s.solve();
  EXPECT_GT(s.error(), 1e-8);
}

// ---- independent solver: without friction the contact forces are a nonnegative
// least-squares prob

/// u of  min u'K u / 2 - b'u  subject to u_n <= gap  by its dual: with K = L L' and u =
/// K^-1 (b - N'x), minimise |L^-1 N' x - L^-1 b|^2 + 2 gap'x over x >= 0; shown here for
/// gap = 0.
VectorXd frictionless_by_least_squares(const Problem& problem) {
  const ElasticSystem system = problem.system();
  std::vector<int> free;
  for (int dof = 0; dof < system.dof_count(); ++dof)
    if (!system.prescribed[dof]) free.push_back(dof);
  const MatrixXd K = MatrixXd(system.stiffness)(free, free);
  MatrixXd N = MatrixXd::Zero(system.dof_count(), problem.line.node_count());
  for (int i = 0; i < problem.line.node_count(); ++i)
    N.block<2, 1>(2 * problem.line.vertex[i], i) = problem.line.normal.col(i);
  const MatrixXd N_free = N(free, Eigen::all);
  const VectorXd b = system.load(free);
  const Eigen::LLT<MatrixXd> llt(K);
  const MatrixXd G = llt.matrixL().solve(N_free);
  const VectorXd x = nonnegative_least_squares(G, llt.matrixL().solve(b));
  VectorXd u = VectorXd::Zero(system.dof_count());
  const VectorXd u_free = llt.solve(b - N_free * x);
  u(free) = u_free;
  return u;
}

RC_GTEST_PROP(ContactSolution, without_friction_is_the_least_squares_solution,
              ()) {
  Case c = *random_case(0);
  c.support = Support::clamped_top;
  c.multiplier = Multiplier::force;
  c.top_motion.setZero();
  const Problem problem = problem_of(c);
  RC_ASSERT(relative_difference(solved(problem).displacement,
                                frictionless_by_least_squares(problem)) < 1e-9);
}

// ---- properties ---------------------------------------------------------------------------------

RC_GTEST_PROP(ContactSolution, fulfils_complementarity_and_equilibrium, ()) {
  const Case c = *random_case(1);
  const ContactSolution<2> solution = solved(problem_of(c));
  RC_ASSERT(solution.status == ContactStatus::converged);
  RC_ASSERT(solution.complementarity <= 1e-10);
  RC_ASSERT(solution.residual <= 1e-10);
}

RC_GTEST_PROP(ContactSolution,
              in_a_corner_fulfils_complementarity_and_equilibrium,
              (Random random)) {
  const double mu = *real(0, 0.5);
  Problem problem =
      body(irregular(5, 4, 5, 4, random), material(1000, 0.3), {left, bottom});
  add_traction(problem, top, *vector_in(1, 1) - Vector2d(2, 2));
  add_traction(problem, right, *vector_in(1, 1) - Vector2d(2, 2));
  set_friction(problem, mu);
  problem.law.multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  const ContactSolution<2> solution = solved(problem);
  RC_ASSERT(solution.status == ContactStatus::converged);
  RC_ASSERT(solution.complementarity <= 1e-10);
  RC_ASSERT(solution.residual <= 1e-10);
}

RC_GTEST_PROP(ContactSolution,
              with_gap_and_variable_friction_fulfils_complementarity,
              (Random random)) {
  Problem problem = problem_of(*random_case(0));
  const int nodes = problem.line.node_count();
  problem.law.friction = 0.5 * random_vector(nodes, random).cwiseAbs();
  problem.law.gap = 1e-3 * random_vector(nodes, random);
  problem.law.previous = 1e-3 * random_vector(nodes, random);
  problem.law.previous[nodes - 1] = 0;  // a support may stand there
  const ContactSolution<2> solution = solved(problem);
  RC_ASSERT(solution.status == ContactStatus::converged);
  RC_ASSERT(solution.complementarity <= 1e-10);
}

RC_GTEST_PROP(ContactSolution, forces_are_the_mass_times_the_pressures, ()) {
  Case c = *random_case(0.3);
  // every contact dof is free: no pressure is left open
  c.support = Support::clamped_top;
  const Problem problem = problem_of(c);
  const ContactSolution<2> solution = solved(problem);
  const Matrix2Xd force = solution.pressure * contact_mass(problem.line);
  RC_ASSERT((force - solution.force).cwiseAbs().maxCoeff() <=
            1e-12 * problem.b.cwiseAbs().maxCoeff());
}

RC_GTEST_PROP(ContactSolution, scales_with_the_loads, ()) {
  const Case c = *random_case(0.5);
  const double factor = *rc::gen::element(1e-6, 0.3, 7.0, 1e5);
  const ContactSolution<2> one = solved(problem_of(c)),
                           many = solved(problem_of(scaled(c, factor)));
  RC_ASSERT(many.state == one.state);
  RC_ASSERT(relative_difference(many.displacement, factor * one.displacement) <
            1e-9);
  RC_ASSERT((many.pressure - factor * one.pressure).cwiseAbs().maxCoeff() <=
            factor * 1e-8);
}

RC_GTEST_PROP(ContactSolution, of_the_mirrored_body_is_mirrored, ()) {
  const Case c = *random_case(0.5);
  const ContactSolution<2> original = solved(problem_of(c)),
                           image = solved(problem_of(mirrored(c)));
  VectorXd turned_back = image.displacement;
  for (Index v = 0; v < turned_back.size() / 2; ++v) turned_back[2 * v] *= -1;
  RC_ASSERT(relative_difference(turned_back, original.displacement) < 1e-9);
  // nodes run the other way round
  Matrix2Xd pressure = image.pressure.rowwise().reverse();
  pressure.row(1) *= -1;
  RC_ASSERT((pressure - original.pressure).cwiseAbs().maxCoeff() <= 1e-8);
}

RC_GTEST_PROP(ContactSolution, of_the_rotated_body_is_rotated, ()) {
  Case c = *random_case(0.5);
  if (c.support == Support::symmetric_right) c.support = Support::clamped_top;
  const double angle = *real(-3, 3);
  const ContactSolution<2> original = solved(problem_of(c)),
                           image = solved(problem_of(rotated(c, angle)));
  const Matrix2d back = Eigen::Rotation2Dd(-angle).toRotationMatrix();
  VectorXd turned_back = image.displacement;
  turned_back.reshaped(2, turned_back.size() / 2) =
      back * image.displacement.reshaped(2, turned_back.size() / 2);
  RC_ASSERT(relative_difference(turned_back, original.displacement) < 1e-9);
  RC_ASSERT((image.pressure - original.pressure).cwiseAbs().maxCoeff() <= 1e-8);
}

RC_GTEST_PROP(ContactSolution, does_not_depend_on_the_numbering,
              (Random random)) {
  const Case c = *random_case(0.5);
  const Renumbered other = renumbered(c.mesh, random);
  const ContactSolution<2> original = solved(problem_of(c));
  const ContactSolution<2> again = solved(
      problem_of(mapped(c, other.mesh, [](const Vector2d& x) { return x; })));
  VectorXd in_old_order(original.displacement.size());
  for (int v = 0; v < c.mesh.vertex_count(); ++v)
    in_old_order.segment<2>(2 * v) =
        again.displacement.segment<2>(2 * other.vertex[v]);
  RC_ASSERT(relative_difference(in_old_order, original.displacement) < 1e-10);
  RC_ASSERT((again.pressure - original.pressure).cwiseAbs().maxCoeff() <= 1e-9);
}

TEST_P(BothMultipliers,
       without_friction_equals_tresca_without_slip_bound_to_the_bit) {
  Problem problem = example_1(GetParam(), 8);
  set_friction(problem, 0);
  const ContactSolution<2> frictionless = solved(problem);
  EXPECT_EQ(frictionless.force.row(1),
            Eigen::RowVectorXd::Zero(problem.line.node_count()));
  set_friction(problem, 0.5);
  problem.law.slip_bound = everywhere(problem.line, 0);
  EXPECT_EQ(solved(problem).displacement, frictionless.displacement);
  problem.law.slip_bound.resize(0);
  EXPECT_GT(relative_difference(solved(problem).displacement,
                                frictionless.displacement),
            1e-3);
}

TEST_P(BothMultipliers,
       with_trescas_law_fulfils_its_conditions_also_where_the_contact_opens) {
  Problem problem = block_with_three_zones(8);
  problem.law.multiplier = GetParam();
  // (2.19): |r_t| <= k whatever r_n
  problem.law.slip_bound = everywhere(problem.line, 20);
  const ContactSolution<2> solution = solved(problem);
  EXPECT_TRUE(accepted(solution))
      << in_words(solution.status) << ", complementarity "
      << solution.complementarity;
  EXPECT_GT(count(solution, ContactState::open), 0);
}

TEST(ContactSolution, of_a_body_without_loads_is_zero) {
  const ContactSolution<2> solution =
      solved(body(rectangle(3, 3, 3, 3), material(1, 0.3)));
  EXPECT_TRUE(accepted(solution));
  EXPECT_EQ(solution.displacement.cwiseAbs().maxCoeff(), 0);
}

// ---- load steps ---------------------------------------------------------------------------------

RC_GTEST_PROP(ContactSolution,
              of_a_second_step_under_the_same_load_moves_nothing, ()) {
  Problem problem = problem_of(*random_case(0.5));
  const ContactSolution<2> first = solved(problem);
  problem.law.previous =
      contact_components(problem.line, first.displacement).row(1);
  ContactSettings settings;
  settings.initial_state = first.state;
  const ContactSolution<2> second = solved(problem, settings);
  RC_ASSERT(second.status == ContactStatus::converged);
  RC_ASSERT(relative_difference(second.displacement, first.displacement) <
            1e-8);
}

TEST(ContactSolution, unloaded_after_slip_keeps_a_part_of_its_displacement) {
  Problem problem = example_2(Multiplier::force, 0.1, 8);
  const ContactSolution<2> loaded = solved(problem);
  ASSERT_GT(count(loaded, ContactState::slip_backward), 0);
  problem.law.previous =
      contact_components(problem.line, loaded.displacement).row(1);
  add_traction(problem, top, {0, 4});  // a fifth of the load is left
  const ContactSolution<2> unloaded = solved(problem);
  EXPECT_TRUE(accepted(unloaded));
  problem.law.previous.resize(0);
  EXPECT_GT(std::abs(unloaded.displacement[0]),
            1.5 * std::abs(solved(problem).displacement[0]));
}

// ---- progress -----------------------------------------------------------------------------------

std::vector<Progress> told_by(const Problem& problem, ContactSolver solver,
                              ContactSolution<2>& solution) {
  std::vector<Progress> told;
  ContactSettings settings;
  settings.solver = solver;
  settings.report = [&](const Progress& p) { told.push_back(p); };
  solution = solved(problem, settings);
  return without_columns(told);
}

TEST(ContactSolution, tells_of_its_factorisation_and_of_every_step) {
  const Problem problem = example_1(Multiplier::force, 8);
  ContactSolution<2> solution;
  const std::vector<Progress> newton =
      told_by(problem, ContactSolver::newton, solution);
  ASSERT_EQ(static_cast<int>(newton.size()), 1 + solution.iterations);
  EXPECT_STREQ(newton[0].phase, "factorisation");
  EXPECT_EQ(newton[0].step, 0);
  EXPECT_EQ(newton[0].value, problem.A.rows());
  for (int k = 1; k <= solution.iterations; ++k) {
    EXPECT_STREQ(newton[k].phase, "Newton");
    EXPECT_EQ(newton[k].step, k);
  }
  EXPECT_GT(newton[1].value, 1e-6);
  EXPECT_LT(newton.back().value, 1e-10);

  const std::vector<Progress> fixed =
      told_by(problem, ContactSolver::fixed_point, solution);
  ASSERT_EQ(fixed.size(), 1 + solution.history.size());
  EXPECT_STREQ(fixed.back().phase, "fixed point");
  EXPECT_EQ(fixed.back().step, static_cast<int>(solution.history.size()));
  EXPECT_LT(fixed.back().value, 1e-10);
}

// ---- refusals -----------------------------------------------------------------------------------

TEST(ContactSolution, refuses_loads_that_lift_a_body_which_only_contact_holds) {
  Problem problem = example_2(Multiplier::force, 0.3, 4);
  add_traction(problem, top, {0, 6});
  EXPECT_EQ(
      refusal_of(problem),
      "no equilibrium: the loads push the body in a translation along (0, 1), "
      "which neither prescribed "
      "displacements nor "
      "contact forces oppose");
}

TEST(ContactSolution, refuses_friction_that_is_negative_or_not_a_number) {
  Problem problem = example_1(Multiplier::force, 2);
  set_friction(problem, -0.5);
  EXPECT_EQ(refusal_of(problem),
            "friction must be finite and not negative, but value 0 is -0.5");
  set_friction(problem, std::nan(""));
  EXPECT_EQ(refusal_of(problem),
            "friction must be finite and not negative, but value 0 is nan");
}

TEST(ContactSolution, refuses_settings_and_sizes_that_do_not_fit) {
  const Problem problem = example_1(Multiplier::force, 2);
  ContactSettings settings;
  settings.max_iterations = 0;
  EXPECT_EQ(refusal([&] { solved(problem, settings); }),
            "maxit must be at least 1, got 0");
  settings = {};
  settings.initial_state = {ContactState::open};
  EXPECT_EQ(refusal([&] { solved(problem, settings); }),
            "initial state has 1 values where 5 are needed");
  const Problem other = example_1(Multiplier::force, 4);
  EXPECT_EQ(refusal([&] {
              solve_contact(problem.mesh, problem.line, problem.law,
                            other.system());
            }),
            "A has 90 values where 30 are needed");
}

TEST(ContactSolution, fails_when_a_part_of_the_body_is_held_by_nothing) {
  Problem problem = body(joined(rectangle(2, 2, 2, 2), rectangle(2, 2, 2, 2)),
                         material(1, 0.3));
  clamp(problem, top);
  EXPECT_THROW(solved(problem), std::runtime_error);
}

TEST(ContactSolution, every_status_has_words) {
  for (ContactStatus status :
       {ContactStatus::converged, ContactStatus::cycled,
        ContactStatus::singular, ContactStatus::not_converged})
    EXPECT_STRNE(in_words(status), "");
}

}  // namespace
}  // namespace ffcontact
