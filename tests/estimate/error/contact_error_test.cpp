// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/contact_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/estimate/displacement/admissible_displacement.hpp"
#include "support/facing.hpp"
#include "support/problems.hpp"
#include "support/random.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Random tractions, displacements and law on a line of several edges.
struct Fields {
  Problem problem;
  ContactDensities densities;
  VectorXd displacement;
};

/// Of the largest displacement or gap.
double penetration(const ContactLine& line, const ContactLaw<2>& law,
                   const VectorXd& u) {
  return deepest_node(line, law, u).depth / largest_displacement(law, u);
}

enum class Law { coulomb, limited, tresca };

Law any_law() {
  return *rc::gen::element(Law::coulomb, Law::limited, Law::tresca);
}

Fields random_fields(Random& random, Law kind) {
  Fields f{body(rotated(irregular(5, 2, 5, 2, random), 0.3), material(1, 0),
                {bottom, left}),
           {},
           {}};
  const ContactLine& line = f.problem.line;
  f.densities = {random_matrix(2, line.edge_count(), random),
                 random_matrix(2, line.edge_count(), random)};
  f.displacement = random_vector(2 * f.problem.mesh.vertices.cols(), random);
  f.problem.law.friction = random_vector(line.node_count(), random).cwiseAbs();
  f.problem.law.gap = random_vector(line.node_count(), random);
  const VectorXd bound = random_vector(line.node_count(), random).cwiseAbs();
  if (kind == Law::tresca) f.problem.law.slip_bound = bound;
  if (kind == Law::limited) f.problem.law.shear_limit = 0.5 * bound;
  return f;
}

/// 2 int (min(mu |r_n|, k) |w_t| + r_t w_t + r_n (w_n - gap)) over edge e, by the
/// midpoint rule; bounds that are given over the least |n|.
double by_midpoints(const Fields& f, int e) {
  const ContactLine& line = f.problem.line;
  const ContactLaw<2>& law = f.problem.law;
  const int i = line.edge_node(0, e), j = line.edge_node(1, e), steps = 20000;
  const double shortest = frame_at(line, e, 0.5).col(0).norm();
  double sum = 0;
  for (int s = 0; s < steps; ++s) {
    const double x = (s + 0.5) / steps;
    const Matrix2d frame = frame_at(line, e, x);
    const Vector2d w = motion_at(line, law.gap, f.displacement, e, x),
                   r = frame.transpose() *
                       traction_at(line, f.densities, e, x) /
                       frame.col(0).squaredNorm();
    const auto given = [&](const VectorXd& bound) {
      return between(bound[i], bound[j], x) / shortest;
    };
    double bound = law.tresca() ? given(law.slip_bound)
                                : between(law.friction[i], law.friction[j], x) *
                                      std::abs(r[0]);
    if (law.limited()) bound = std::min(bound, given(law.shear_limit));
    sum += bound * std::abs(w[1]) + r.dot(w);
  }
  return 2 * line.length[e] * sum / steps;
}

RC_GTEST_PROP(ContactError, is_its_quadrature, (Random random)) {
  Fields f = random_fields(random, any_law());
  if (random() % 2 == 0)
    f.problem.line = turned_at_random(f.problem.line, 0.7, random);
  const VectorXd error =
      contact_error(f.problem.line, f.problem.law, f.densities, f.displacement);
  const int e = random() % f.problem.line.edge_count();
  RC_ASSERT(std::abs(error[e] - by_midpoints(f, e)) < 1e-7);
}

RC_GTEST_PROP(ContactError, is_not_negative_in_the_cone_without_penetration,
              (Random random)) {
  Fields f = random_fields(random, Law::coulomb);
  const ContactLine& line = f.problem.line;
  f.problem.law.friction.setConstant(0.5);
  f.densities.normal = -f.densities.normal.cwiseAbs();
  f.densities.tangential =
      f.densities.tangential.cwiseProduct(0.5 * f.densities.normal);
  f.problem.law.gap =
      contact_components(line, f.displacement).row(0).transpose() +
      random_vector(line.node_count(), random).cwiseAbs();
  RC_ASSERT(contact_error(line, f.problem.law, f.densities, f.displacement)
                .minCoeff() >= 0);
}

RC_GTEST_PROP(ContactError, between_nodes_no_integrand_is_negative_in_the_cone,
              (Random random)) {
  Fields f = random_fields(random, Law::coulomb);
  const ContactLine& line = f.problem.line;
  ContactLaw<2>& law = f.problem.law;
  law.friction.setConstant(0.5);
  f.densities.normal = -f.densities.normal.cwiseAbs();
  f.densities.tangential =
      f.densities.tangential.cwiseProduct(0.5 * f.densities.normal);
  law.gap = contact_components(line, f.displacement).row(0).transpose() +
            random_vector(line.node_count(), random).cwiseAbs();
  const auto found = [&] {
    return between_nodes(line, law, f.densities, f.displacement);
  };
  RC_ASSERT(found().negative < 1e-13);
  RC_ASSERT(found().turn == 0);
  const int e = random() % line.edge_count();
  law.gap[line.edge_node(1, e)] -= 3;
  RC_ASSERT(found().negative > 0);
}

RC_GTEST_PROP(ContactError, directions_may_turn_by_less_than_90_degrees_an_edge,
              (Random random)) {
  Fields f = random_fields(random, Law::coulomb);
  ContactLine& line = f.problem.line;
  f.problem.law.gap.setConstant(100);
  const int e = random() % line.edge_count();
  const int node = line.edge_node(1, e);
  const Matrix2d frame = line.frame(node);
  const auto found = [&](double angle) {
    line.normal.col(node) = frame * Vector2d(std::cos(angle), std::sin(angle));
    return between_nodes(line, f.problem.law, f.densities, f.displacement);
  };
  RC_ASSERT(found(1.5).turn == 0);
  RC_ASSERT(std::abs(found(1.6).turn - 1.6) < 1e-12);
  f.densities.normal.setZero();
  f.densities.tangential.setZero();
  RC_ASSERT(found(1.6).turn == 0);
}

RC_GTEST_PROP(ContactError,
              in_the_cone_is_linear_in_the_tractions_with_the_costs,
              (Random random)) {
  Fields f =
      random_fields(random, *rc::gen::element(Law::coulomb, Law::tresca));
  f.densities.normal = -f.densities.normal.cwiseAbs();
  const TractionCosts costs = traction_costs(f.problem.line, f.problem.law,
                                             f.densities, f.displacement);
  const ContactDensities none{Matrix2Xd::Zero(2, f.problem.line.edge_count()),
                              Matrix2Xd::Zero(2, f.problem.line.edge_count())};
  const double error =
      (contact_error(f.problem.line, f.problem.law, f.densities,
                     f.displacement) -
       contact_error(f.problem.line, f.problem.law, none, f.displacement))
          .sum();
  const double linear =
      costs.normal.cwiseProduct(f.densities.normal).sum() +
      costs.tangential.cwiseProduct(f.densities.tangential).sum();
  RC_ASSERT(std::abs(error - linear) < 1e-12 * f.problem.line.edge_count());
}

RC_GTEST_PROP(ContactError,
              with_a_shear_limit_changes_by_no_more_than_the_costs_say,
              (Random random)) {
  Fields f = random_fields(random, Law::limited);
  const ContactLine& line = f.problem.line;
  f.densities.normal = -f.densities.normal.cwiseAbs();
  const TractionCosts costs =
      traction_costs(line, f.problem.law, f.densities, f.displacement);
  ContactDensities other{
      -random_matrix(2, line.edge_count(), random).cwiseAbs(),
      random_matrix(2, line.edge_count(), random)};
  const VectorXd change =
      contact_error(line, f.problem.law, other, f.displacement) -
      contact_error(line, f.problem.law, f.densities, f.displacement);
  const VectorXd said =
      costs.normal.cwiseProduct(other.normal - f.densities.normal)
          .colwise()
          .sum() +
      costs.tangential.cwiseProduct(other.tangential - f.densities.tangential)
          .colwise()
          .sum();
  RC_ASSERT((change - said).maxCoeff() < 1e-12);
  other.normal =
      (1 + 1e-7) * f.densities.normal;  // close by, they are the change itself
  other.tangential = f.densities.tangential;
  const VectorXd near =
      contact_error(line, f.problem.law, other, f.displacement) -
      contact_error(line, f.problem.law, f.densities, f.displacement);
  const VectorXd slope =
      costs.normal.cwiseProduct(other.normal - f.densities.normal)
          .colwise()
          .sum();
  RC_ASSERT((near - slope).cwiseAbs().maxCoeff() < 1e-12);
}

TEST(ContactError, of_slip_at_the_bound_against_the_motion_is_zero) {
  const Problem problem = body(rectangle(4, 1, 4, 1), material(1, 0));
  ContactLaw<2> law = problem.law;
  law.friction = everywhere(problem.line, 0.5);
  const VectorXd u = nodal_values(
      problem.mesh, [](const Vector2d&) { return Vector2d(2, 0); });
  ContactDensities densities{Matrix2Xd::Constant(2, 4, -3),
                             Matrix2Xd::Constant(2, 4, -1.5)};
  EXPECT_EQ(contact_error(problem.line, law, densities, u), VectorXd::Zero(4));
  densities.tangential(0, 1) +=
      0.1;  // spoiled: 2 int 0.1 phi 2 over an edge of length 1
  EXPECT_NEAR(contact_error(problem.line, law, densities, u)[1], 0.2, 1e-14);
}

RC_GTEST_PROP(AdmissibleDisplacement,
              lowers_penetrating_nodes_to_the_foundation_and_nothing_else,
              (Random random)) {
  const Fields f = random_fields(random, Law::coulomb);
  Problem problem = body(f.problem.mesh, material(1, 0));
  problem.law.gap = random_vector(problem.line.node_count(), random);
  const VectorXd u =
      admissible_displacement(problem.line, problem.law, f.displacement);
  const Matrix2Xd before = contact_components(problem.line, f.displacement);
  const Matrix2Xd after = contact_components(problem.line, u);
  VectorXd changed = u - f.displacement;
  for (int i = 0; i < problem.line.node_count(); ++i) {
    RC_ASSERT(std::abs(after(0, i) -
                       std::min(before(0, i), problem.law.gap[i])) < 1e-14);
    RC_ASSERT(std::abs(after(1, i) - before(1, i)) < 1e-14);
    changed.segment<2>(2 * problem.line.vertex[i]).setZero();
  }
  RC_ASSERT(changed.isZero(0));
}

TEST(AdmissibleDisplacement,
     keeps_prescribed_components_and_lowers_by_the_others) {
  const Problem problem =
      body(rotated(rectangle(2, 1, 2, 1), 0.5), material(1, 0));
  const ContactLine& line = problem.line;
  VectorXd u = VectorXd::Zero(problem.b.size());
  u.segment<2>(2 * line.vertex[1]) = 0.1 * line.normal.col(1);
  for (int held = 0; held < 2; ++held) {
    std::vector<char> prescribed(u.size(), 0);
    prescribed[2 * line.vertex[1] + held] = 1;
    const VectorXd lowered =
        admissible_displacement(line, problem.law, u, prescribed);
    EXPECT_EQ(lowered[2 * line.vertex[1] + held], u[2 * line.vertex[1] + held]);
    EXPECT_NEAR(contact_components(line, lowered)(0, 1), 0, 1e-15);
    EXPECT_LT(penetration(line, problem.law, lowered), 1e-14);
  }
}

TEST(AdmissibleDisplacement, is_left_where_prescribed_components_penetrate) {
  const Problem problem =
      // hardly anything of n is along x
      body(rotated(rectangle(2, 1, 2, 1), 1e-9), material(1, 0));
  const ContactLine& line = problem.line;
  VectorXd u = VectorXd::Zero(problem.b.size());
  u[2 * line.vertex[1] + 1] = -0.1;
  std::vector<char> prescribed(u.size(), 0);
  prescribed[2 * line.vertex[1] + 1] = 1;
  EXPECT_EQ(admissible_displacement(line, problem.law, u, prescribed), u);
  EXPECT_NEAR(penetration(line, problem.law, u), 1, 1e-12);
  EXPECT_EQ(deepest_node(line, problem.law, u).node, 1);
}

TEST(AdmissibleDisplacement, moves_what_prescribed_vertices_face) {
  const Mesh upper = shifted(rectangle(3, 1, 3, 1), {0, 1});
  const Facing bodies(upper, rectangle(4, 1, 3, 1));
  ContactLaw<2> law;
  law.friction = everywhere(bodies.line, 0.3);
  law.gap = everywhere(bodies.line, 0);
  const int pressed = 2 * upper.vertex_count();
  VectorXd u = VectorXd::Zero(2 * bodies.joined.mesh.vertex_count());
  std::vector<char> prescribed(u.size(), 0);
  for (int dof = 0; dof < pressed; ++dof) {
    u[dof] = dof % 2 == 0 ? 0 : -0.1;
    prescribed[dof] = 1;
  }
  const VectorXd clear =
      admissible_displacement(bodies.line, law, u, prescribed);
  EXPECT_NEAR(penetration(bodies.line, law, u), 1, 1e-12);
  EXPECT_LT(penetration(bodies.line, law, clear), 1e-13);
  EXPECT_EQ(clear.head(pressed), u.head(pressed));
}

TEST(DeepestNode, is_at_depth_zero_clear_of_the_foundation_and_counts_the_gap) {
  const Problem problem = body(rectangle(2, 1, 2, 1), material(1, 0));
  ContactLaw<2> law = problem.law;
  const VectorXd u = nodal_values(
      problem.mesh, [](const Vector2d&) { return Vector2d(0, -1); });
  EXPECT_NEAR(penetration(problem.line, law, u), 1, 1e-15);
  law.gap = everywhere(problem.line, 1);
  EXPECT_EQ(penetration(problem.line, law, u), 0);
  law.gap[2] = 0.5;
  EXPECT_NEAR(penetration(problem.line, law, u), 0.5, 1e-15);
}

TEST(AdmissibleDisplacement, does_not_penetrate_at_a_sharp_corner) {
  // A corner of 45 degrees: lowering along one normal pushes against the other.
  Mesh mesh = rectangle(2, 2, 2, 2);
  for (int v = 0; v < mesh.vertex_count(); ++v)
    mesh.vertices(0, v) += mesh.vertices(1, v);
  const Problem problem = body(mesh, material(1, 0), {left, bottom});
  const VectorXd u =
      nodal_values(mesh, [](const Vector2d&) { return Vector2d(-1, -1); });
  const Matrix2Xd w = contact_components(
      problem.line, admissible_displacement(problem.line, problem.law, u));
  EXPECT_LE(w.row(0).maxCoeff(), 1e-14);
}

TEST(AdmissibleDisplacement,
     moves_a_roller_back_on_a_line_that_it_all_but_runs_along) {
  const Problem problem =
      body(rotated(rectangle(4, 1, 4, 1), 1e-5), material(1, 0));
  const VectorXd u = nodal_values(
      problem.mesh, [](const Vector2d&) { return Vector2d(1, 0); });
  std::vector<char> rollers(u.size(), 0);
  for (Index dof = 1; dof < u.size(); dof += 2) rollers[dof] = 1;
  ASSERT_GT(penetration(problem.line, problem.law, u), 9e-6);
  const VectorXd u_hat =
      admissible_displacement(problem.line, problem.law, u, rollers);
  EXPECT_LT(penetration(problem.line, problem.law, u_hat), 1e-12);
  for (int node : problem.line.vertex) EXPECT_NEAR(u_hat[2 * node], 0, 1e-9);
}

}  // namespace
}  // namespace ffcontact
