// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/nearest_in_cone.hpp"

#include <gtest/gtest.h>

#include "ffcontact/elastic/rigid_motions.hpp"
#include "support/problems.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

ContactDensities random_densities(Index edges, Random& random) {
  return {random_matrix(2, edges, random).array() - 0.5,
          random_matrix(2, edges, random)};
}

/// A line of six edges; friction or Tresca's bound varies along it, and is 0 at some
/// nodes.
Problem random_line(Random& random) {
  Problem problem = body(rotated(irregular(6, 2, 6, 2, random), *real(-3, 3)),
                         material(1, 0));
  problem.law.friction =
      random_vector(problem.line.node_count(), random).cwiseAbs();
  if (*rc::gen::arbitrary<bool>())
    set_friction(problem, *rc::gen::element(0.0, 1e-3, 0.4));
  if (*rc::gen::inRange(0, 3) == 0) problem.law.friction[2] = 0;
  if (*rc::gen::inRange(0, 3) == 0)
    problem.law.slip_bound = problem.law.friction;
  return problem;
}

MatrixXd all_motions(const Problem& problem) {
  return free_rigid_motions(problem.mesh,
                            std::vector<char>(problem.b.size(), 0));
}

ContactDensities nearest(const Problem& problem,
                         const ContactDensities& densities,
                         const MatrixXd& motions, const VectorXd& resultants) {
  const auto r = nearest_in_cone(problem.line, problem.law, densities, motions,
                                 resultants);
  RC_ASSERT(r.has_value());
  return *r;
}

/// Random densities in the cone.
ContactDensities inside(const Problem& problem, Random& random) {
  ContactDensities r = random_densities(problem.line.edge_count(), random);
  for (int e = 0; e < problem.line.edge_count(); ++e)
    set_end_values(
        r, e, clamped_to_cone(problem.line, problem.law, e, end_values(r, e)));
  return r;
}

/// int |r - s|^2 over the line.
double squared_distance(const ContactLine& line, const ContactDensities& r,
                        const ContactDensities& s) {
  double sum = 0;
  for (int e = 0; e < line.edge_count(); ++e) {
    const Matrix2d d = (end_values(r, e) - end_values(s, e)).reshaped(2, 2);
    sum += line.length[e] * (d.squaredNorm() + d.col(0).dot(d.col(1))) / 3;
  }
  return sum;
}

ContactDensities between(const ContactDensities& r, const ContactDensities& s,
                         double share) {
  return {r.normal + share * (s.normal - r.normal),
          r.tangential + share * (s.tangential - r.tangential)};
}

RC_GTEST_PROP(NearestInCone, no_other_density_in_the_cone_is_nearer,
              (Random random)) {
  const Problem problem = random_line(random);
  const ContactDensities given =
      random_densities(problem.line.edge_count(), random);
  const ContactDensities r =
      nearest(problem, given, MatrixXd(problem.b.size(), 0), {});
  RC_ASSERT(cone_defect(problem.line, problem.law, r) <= 1e-12);
  const double distance = squared_distance(problem.line, r, given);
  for (int trial = 0; trial < 20; ++trial) {
    const ContactDensities other = inside(problem, random);
    for (const double share : {1.0, 0.1, 0.01})  // the cone is convex
      RC_ASSERT(squared_distance(problem.line, between(r, other, share),
                                 given) >= distance - 1e-12);
  }
}

/// Resultants of any tractions in the cone are met, by tractions that are no farther than
/// those.
RC_GTEST_PROP(NearestInCone,
              has_every_resultant_that_tractions_in_the_cone_have,
              (Random random)) {
  const Problem problem = random_line(random);
  const ContactLine& line = problem.line;
  const MatrixXd motions = all_motions(problem);
  const ContactDensities given = random_densities(line.edge_count(), random),
                         other = inside(problem, random);
  const VectorXd wanted = resultants_of(line, other, motions);
  const ContactDensities r = nearest(problem, given, motions, wanted);
  RC_ASSERT(cone_defect(line, problem.law, r) <= 1e-12);
  RC_ASSERT((resultants_of(line, r, motions) - wanted).norm() <= 1e-11);
  RC_ASSERT(squared_distance(line, r, given) <=
            squared_distance(line, other, given) + 1e-10);
}

/// With mu > 1 both sides of a right angle hold a body against a pull: opposite forces
/// wedge it, far larger than the pull.
TEST(NearestInCone, finds_tractions_far_larger_than_their_resultant) {
  constexpr double mu = 1.005, taken = 1.0045;
  Problem problem = body(rectangle(4, 4, 4, 4), material(1, 0), {bottom, left});
  set_friction(problem, mu);
  const ContactLine& line = problem.line;
  const MatrixXd motions = all_motions(problem);
  const Matrix2Xd zero = Matrix2Xd::Zero(2, line.edge_count());
  ContactDensities wedged{zero.array() - 1, zero};
  for (int e = 0; e < line.edge_count(); ++e) {
    const bool is_left = line.normal(0, line.edge_node(0, e)) < -0.5;
    wedged.tangential.col(e).setConstant(is_left ? taken : -taken);
  }
  const VectorXd pull = resultants_of(line, wedged, motions);
  ASSERT_LT(pull.norm(), 0.1);
  const auto r =
      nearest_in_cone(line, problem.law, {zero, zero}, motions, pull);
  ASSERT_TRUE(r.has_value());
  EXPECT_GT(r->normal.cwiseAbs().maxCoeff(), 0.5);
  EXPECT_LE(cone_defect(line, problem.law, *r), 1e-12);
  EXPECT_LT((resultants_of(line, *r, motions) - pull).norm(), 1e-12);
}

TEST(NearestInCone, is_nothing_where_the_cone_has_no_such_resultant) {
  Problem problem = body(rectangle(4, 1, 4, 1), material(1, 0));
  set_friction(problem, 0.3);
  const MatrixXd motions = all_motions(problem);
  ContactDensities pulled{Matrix2Xd::Constant(2, 4, 1), Matrix2Xd::Zero(2, 4)};
  EXPECT_FALSE(nearest_in_cone(problem.line, problem.law, pulled, motions,
                               resultants_of(problem.line, pulled, motions))
                   .has_value());
  // a force on the end of the line: densities have their centre inside
  const ContactDensities none{Matrix2Xd::Zero(2, 4), Matrix2Xd::Zero(2, 4)};
  const VectorXd force = motions.middleRows<2>(0).transpose() * Vector2d(0, 1);
  EXPECT_FALSE(nearest_in_cone(problem.line, problem.law, none, motions, force)
                   .has_value());
}

TEST(NearestInCone, of_trescas_law_lets_one_end_make_up_for_the_other) {
  Problem problem = body(rectangle(1, 1, 1, 1), material(1, 0));
  problem.law.slip_bound = everywhere(problem.line, 1);
  // tangential 2 at the first end must come down to 1: then 1 at the second is nearest
  const ContactDensities given{Vector2d(-1, -1), Vector2d(2, 0.5)};
  const auto r = nearest_in_cone(problem.line, problem.law, given,
                                 MatrixXd(problem.b.size(), 0), {});
  ASSERT_TRUE(r.has_value());
  EXPECT_LT((end_values(*r, 0) - Vector4d(-1, 1, -1, 1)).cwiseAbs().maxCoeff(),
            1e-12);
}

}  // namespace
}  // namespace ffcontact
