// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/condensed/condensed_contact.hpp"

#include <gtest/gtest.h>

#include "ffcontact/elastic/stiffness.hpp"
#include "support/cases.hpp"
#include "support/condensed.hpp"
#include "support/condensed_problems.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

VectorXd weighted_trace(const Problem& problem, const VectorXd& u) {
  const Matrix2Xd trace =
      displacement_against_foundation(problem.line, problem.law, u);
  return weight_of_rows(problem.law.multiplier, problem.line) *
         trace.reshaped();
}

/// Loads on all dofs of multipliers on all rows.
VectorXd load_of(const Problem& problem, const VectorXd& P) {
  const VectorXd force =
      weight_of_rows(problem.law.multiplier, problem.line) * P;
  VectorXd load = VectorXd::Zero(problem.b.size());
  for (int i = 0; i < problem.line.node_count(); ++i) {
    const Vector2d F = force[2 * i] * problem.line.normal.col(i) +
                       force[2 * i + 1] * problem.line.tangent(i);
    load.segment<2>(2 * problem.line.vertex[i]) += F;
    visit_opposite(problem.line, i, [&](int v, double weight) {
      load.segment<2>(2 * v) -= weight * F;
    });
  }
  return load;
}

Problem random_problem(Random& random) {
  const Multiplier multiplier =
      *rc::gen::element(Multiplier::force, Multiplier::pressure);
  switch (*rc::gen::inRange(0, 3)) {
    case 0: return cornered_body(random, multiplier);
    case 1: return facing_bodies(random, multiplier);
    default: return problem_of(*random_case(0.5));
  }
}

RC_GTEST_PROP(CondensedContact,
              v_is_the_weighted_trace_of_the_extended_displacement,
              (Random random)) {
  const Condensed c(random_problem(random));
  const VectorXd v = random_vector(c.contact.S.rows(), random),
                 q = random_vector(c.contact.E.cols(), random);
  const VectorXd u =
      c.stiffness.extended(c.contact.load, kept_displacement(c.contact, v, q)) +
      c.system.prescribed_value;
  const VectorXd trace = weighted_trace(c.problem, u);
  const VectorXd dependent = c.contact.E.transpose() * v + c.contact.F * q +
                             c.contact.dependent_offset;
  const double scale =
      1e-11 * std::max(trace.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff());
  for (int row = 0; row < trace.size(); ++row) {
    const int k = c.contact.position[row];
    RC_ASSERT(std::abs(trace[row] - (k >= 0 ? v[k] : dependent[-1 - k])) <
              scale);
  }
}

RC_GTEST_PROP(CondensedContact,
              multipliers_hold_the_displacement_in_equilibrium,
              (Random random)) {
  const Condensed c(random_problem(random));
  const VectorXd v = random_vector(c.contact.S.rows(), random);
  const VectorXd q = random_vector(c.contact.E.cols(), random);
  const VectorXd P_primary = c.contact.S * v - c.contact.g - c.contact.E * q;
  VectorXd P(2 * c.problem.line.node_count());
  for (int row = 0; row < P.size(); ++row) {
    const int k = c.contact.position[row];
    P[row] = k >= 0 ? P_primary[k] : q[-1 - k];
  }
  const VectorXd u =
      c.stiffness.extended(c.contact.load, kept_displacement(c.contact, v, q));
  const VectorXd load = load_of(c.problem, P),
                 residual = c.system.stiffness * u - c.system.load - load;
  const double scale = 1e-10 * std::max(load.cwiseAbs().maxCoeff(),
                                        c.system.load.cwiseAbs().maxCoeff());
  for (int dof = 0; dof < c.system.dof_count(); ++dof)
    RC_ASSERT((c.system.prescribed[dof] || std::abs(residual[dof]) < scale));
}

TEST(CondensedContact,
     rows_are_primary_or_dependent_and_as_many_as_free_dofs_are_primary) {
  const Condensed c(example_1(Multiplier::force, 2));
  EXPECT_EQ(c.contact.primary.size(), 9u);
  // the tangential row on the symmetry line
  EXPECT_EQ(c.contact.dependent, std::vector<int>{9});
  EXPECT_TRUE(c.contact.is_primary(8));
  EXPECT_EQ(c.contact.kept_dofs.size(), 9u);
  EXPECT_EQ(c.contact.S, c.contact.S.transpose());
}

TEST(CondensedContact, second_node_of_a_corner_is_dependent) {
  Random random(3);
  const Condensed c(cornered_body(random, Multiplier::force));
  // the corner's second node; both rows of the vertex on the clamped side
  const int corners = 1, prescribed = 2;
  EXPECT_EQ(static_cast<int>(c.contact.dependent.size()),
            2 * corners + prescribed);
}

TEST(CondensedContact, refuses_a_line_without_free_dofs) {
  Problem problem = body(rectangle(2, 2, 2, 2), material(1, 0));
  clamp(problem, bottom);
  const ElasticSystem system = problem.system();
  const CondensedStiffness stiffness(system,
                                     contact_dofs(problem.line, system));
  EXPECT_EQ(refusal([&] {
              condensed_contact(problem.line, problem.law, system, stiffness);
            }),
            "every dof of the contact line is prescribed");
}

}  // namespace
}  // namespace ffcontact
