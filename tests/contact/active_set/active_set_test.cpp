// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set/active_set.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "ffcontact/contact/fixed_point/fixed_point.hpp"
#include "support/cases.hpp"
#include "support/condensed.hpp"

namespace ffcontact {
namespace {

using namespace test;

using States = std::vector<ContactState>;

constexpr ContactState all_states[] = {ContactState::open, ContactState::stick,
                                       ContactState::slip_forward,
                                       ContactState::slip_backward};

double violation(const NodalLaw& law, const ContactRows& rows) {
  return law_violation(law, rows.P, rows.v, {rows.v.cwiseAbs().maxCoeff(), 0});
}

/// The answers of all 4^p active sets that fulfil the law.
std::vector<ContactRows> all_solutions(const Condensed& small) {
  std::vector<ContactRows> found;
  const int nodes = small.problem.line.node_count();
  for (int code = 0; code < 1 << (2 * nodes); ++code) {
    States state(nodes);
    for (int i = 0; i < nodes; ++i) state[i] = all_states[code >> (2 * i) & 3];
    ContactRows rows;
    const SystemKind kind =
        solve_active_set(small.contact, small.law, state, rows);
    if (kind == SystemKind::regular && violation(small.law, rows) < 1e-11)
      found.push_back(rows);
  }
  return found;
}

/// A block of few cells, clamped at the top, with random loads.
Problem small_problem(int cells, double mu, Random& random) {
  Problem problem = body(moved(rectangle(cells, 2, 3, 2), 0.5, 0.2, random),
                         material(1000, 0.3));
  add_traction(problem, left, random_vector(2, random));
  add_traction(problem, right, random_vector(2, random));
  clamp(problem, top,
        [motion = Vector2d(0.004 * random_vector(2, random))](const Vector2d&) {
          return motion;
        });
  set_friction(problem, mu);
  problem.law.multiplier =
      random() % 2 == 0 ? Multiplier::force : Multiplier::pressure;
  return problem;
}

States random_states(int nodes, Random& random) {
  States state(nodes);
  for (ContactState& s : state) s = all_states[random() % 4];
  return state;
}

/// Newton, and the fixed point helped by it where its states do not settle.
ActiveSetResult solved_from(const Condensed& small, const States& start) {
  const ActiveSetResult newton =
      active_set_newton(small.contact, small.law, start);
  if (newton.status != ContactStatus::cycled) return newton;
  return fixed_point(small.contact, small.law, start, {500, 1e-10}, true)
      .answer;
}

RC_GTEST_PROP(ActiveSet, finds_the_solution_that_brute_force_finds,
              (Random random)) {
  const Condensed small(
      small_problem(*rc::gen::inRange(1, 4), *real(0, 0.5), random));
  const std::vector<ContactRows> solutions = all_solutions(small);
  const ActiveSetResult result = solved_from(small, small.sticking);
  RC_ASSERT(result.status == ContactStatus::converged);
  RC_ASSERT(!solutions.empty());
  for (const ContactRows& rows :
       solutions) {  // several active sets may have one answer
    RC_ASSERT((result.v - rows.v).cwiseAbs().maxCoeff() <=
              1e-10 * rows.v.cwiseAbs().maxCoeff());
    RC_ASSERT((result.P - rows.P).cwiseAbs().maxCoeff() <=
              1e-9 * small.contact.g.cwiseAbs().maxCoeff());
  }
}

RC_GTEST_PROP(ActiveSet, answer_does_not_depend_on_the_first_guess,
              (Random random)) {
  const Condensed small(
      small_problem(*rc::gen::inRange(1, 7), *real(0, 0.3), random));
  const int nodes = small.problem.line.node_count();
  const ActiveSetResult reference = solved_from(small, small.sticking);
  const ActiveSetResult result =
      solved_from(small, random_states(nodes, random));
  RC_ASSERT(reference.status == ContactStatus::converged);
  RC_ASSERT(result.status == ContactStatus::converged);
  RC_ASSERT((result.v - reference.v).cwiseAbs().maxCoeff() <=
            1e-10 * reference.v.cwiseAbs().maxCoeff());
}

RC_GTEST_PROP(ActiveSet, converged_multipliers_are_in_the_law_exactly,
              (Random random)) {
  const Condensed small(
      small_problem(*rc::gen::inRange(1, 7), *real(0, 1), random));
  const ActiveSetResult result =
      active_set_newton(small.contact, small.law, small.sticking);
  RC_PRE(result.status == ContactStatus::converged);
  for (std::size_t i = 0; i < result.state.size(); ++i) {
    const double Pn = result.P[2 * i], Pt = result.P[2 * i + 1];
    RC_ASSERT(Pn <= 0);
    RC_ASSERT(std::abs(Pt) <= small.law.cone[i].bound(Pn));
    if (result.state[i] == ContactState::open) RC_ASSERT(Pn == 0);
  }
}

RC_GTEST_PROP(ActiveSet, a_solution_is_found_again_in_one_step,
              (Random random)) {
  const Condensed small(
      small_problem(*rc::gen::inRange(1, 7), *real(0, 0.5), random));
  const ActiveSetResult first =
      active_set_newton(small.contact, small.law, small.sticking);
  RC_PRE(first.status == ContactStatus::converged);
  const ActiveSetResult again =
      active_set_newton(small.contact, small.law, first.state);
  RC_ASSERT(again.iterations == 1);
  RC_ASSERT(again.v == first.v);
}

TEST(ActiveSet, says_when_its_iterations_are_used_up) {
  const Condensed small(example_1(Multiplier::force, 8));
  const ActiveSetResult result =
      active_set_newton(small.contact, small.law, small.sticking, {1, 1e-10});
  EXPECT_EQ(result.status, ContactStatus::not_converged);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_GT(result.violation, 1e-10);
}

/// With all nodes open nothing holds the body: it falls the way of its loads, and the
/// next set is closed.
TEST(ActiveSet, finds_contact_from_open_nodes_that_let_the_body_go) {
  for (const Multiplier multiplier : {Multiplier::force, Multiplier::pressure})
    for (int cells = 1; cells <= 12; ++cells) {
      const Condensed small(example_2(multiplier, 0.3, cells));
      const States open(small.problem.line.node_count(), ContactState::open);
      EXPECT_EQ(active_set_newton(small.contact, small.law, open).status,
                ContactStatus::converged)
          << cells;
    }
}

TEST(ActiveSet, frictionless_nodes_never_stick) {
  const Condensed small(example_2(Multiplier::force, 0, 8));
  const ActiveSetResult result =
      active_set_newton(small.contact, small.law, small.sticking);
  ASSERT_EQ(result.status, ContactStatus::converged);
  for (ContactState state : result.state) EXPECT_NE(state, ContactState::stick);
}

TEST(LawViolation, sees_every_spoiled_condition) {
  const NodalLaw law{std::vector<FrictionCone>(3, {0, 0.5})};
  VectorXd P(6), v(6);  // open, stick, slip forward
  P << 0, 0, -4, 1, -2, -1;
  v << -3, 1, 0, 0, 0, 2;
  const auto with = [&](int row, double p, double w) {
    VectorXd P2 = P, v2 = v;
    P2[row] += p;
    v2[row] += w;
    return law_violation(law, P2, v2, {1, 0});
  };
  EXPECT_EQ(with(0, 0, 0), 0);
  EXPECT_NEAR(with(0, 0.04, 0), 0.01, 1e-12);   // P_n > 0: 0.04 / 4
  EXPECT_NEAR(with(2, 0, 0.01), 0.01, 1e-12);   // v_n > 0
  EXPECT_NEAR(with(2, 0, -0.01), 0.01, 1e-12);  // P_n v_n
  EXPECT_NEAR(with(3, 1.04, 0), 0.01, 1e-12);   // |P_t| > b
  EXPECT_NEAR(with(3, 0, 0.01), 0.01, 1e-12);   // sticks but moves
  EXPECT_NEAR(with(5, 0.04, 0), 0.01, 1e-12);   // slips below the bound
  EXPECT_NEAR(with(5, 2, 0), 0.5, 1e-12);       // pushed along: P_t = +b
}

/// Neither is what must be 0 excused by the other one being small.
TEST(LawViolation,
     is_the_smaller_one_of_two_that_may_not_both_differ_from_zero) {
  const NodalLaw law{{{0, 0.5}}};
  const Vector2d P(-1, 0.5);
  EXPECT_NEAR(law_violation(law, P, Vector2d(-1e-6, 0), {1, 0}), 1e-6, 1e-15);
  EXPECT_NEAR(law_violation(law, P, Vector2d(0, 1e-6), {1, 0}), 1e-6, 1e-15);
  EXPECT_EQ(law_violation(law, P, Vector2d(0, -1e-6), {1, 0}), 0);
}

/// Forces that friction could hold without any load are no answer.
TEST(LawViolation,
     is_infinite_where_the_loads_are_rounding_beside_the_multipliers) {
  const Condensed small(example_1(Multiplier::force, 2));
  ContactRows rows{VectorXd::Zero(10), VectorXd::Zero(10)};
  const double load = small.contact.g.cwiseAbs().maxCoeff();
  rows.P[0] = -1e9 * load;
  EXPECT_EQ(law_violation(small.contact, small.law, rows), 0);
  rows.P[0] = -1e11 * load;
  EXPECT_EQ(law_violation(small.contact, small.law, rows),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace ffcontact
