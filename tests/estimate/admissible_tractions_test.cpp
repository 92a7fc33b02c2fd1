// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/admissible_tractions.hpp"

#include <gtest/gtest.h>

#include "ffcontact/elastic/rigid_motions.hpp"
#include "support/problems.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

ContactDensities random_densities(Eigen::Index edges, Random& random) {
  return {random_matrix(2, edges, random).array() - 0.5, random_matrix(2, edges, random)};
}

Problem random_line(Random& random, bool tresca) {
  Problem problem = body(irregular(6, 2, 6, 2, random), material(1, 0));
  set_friction(problem, *real(0, 1));
  if (tresca) problem.law.slip_bound = everywhere(problem.line, *real(0, 1));
  return problem;
}

/// int |r - s|^2 over an edge of length 1.
double squared_distance(const Eigen::Matrix2d& r, const Eigen::Matrix2d& s) {
  const Eigen::Matrix2d d = r - s;
  return (d.squaredNorm() + d.col(0).dot(d.col(1))) / 3;
}

/// A random density of the law at both ends.
Eigen::Matrix2d density_inside(const ContactLaw& law, Random& random) {
  Eigen::Matrix2d r = 2 * random_matrix(2, 2, random);
  r.row(0) = -r.row(0).cwiseAbs();
  for (int end = 0; end < 2; ++end) {
    const double bound = law.tresca() ? law.slip_bound[end] : -law.friction[end] * r(0, end);
    r(1, end) = std::clamp(r(1, end), -bound, bound);
  }
  return r;
}

void no_other_is_nearer(const Problem& problem, Random& random) {
  const Eigen::Matrix2d density = 2 * random_matrix(2, 2, random);
  const Eigen::Matrix2d nearest = nearest_in_cone(problem.law, 0, 1, density);
  const double distance = squared_distance(nearest, density);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Matrix2d other = density_inside(problem.law, random);
    for (double step : {1.0, 0.1, 0.01})  // the law is convex
      RC_ASSERT(squared_distance(nearest + step * (other - nearest), density) >= distance - 1e-12);
  }
}

RC_GTEST_PROP(NearestInCone, no_other_density_of_coulombs_law_is_nearer, (Random random)) {
  no_other_is_nearer(random_line(random, false), random);
}

RC_GTEST_PROP(NearestInCone, no_other_density_of_trescas_law_is_nearer, (Random random)) {
  no_other_is_nearer(random_line(random, true), random);
}

TEST(NearestInCone, of_trescas_law_lets_one_end_make_up_for_the_other) {
  Problem problem = body(rectangle(1, 1, 1, 1), material(1, 0));
  problem.law.slip_bound = everywhere(problem.line, 1);
  Eigen::Matrix2d density;
  density << -1, -1, 2, 0.5;  // tangential 2 at the first end must come down to 1: then 1 at the second is nearest
  const Eigen::Matrix2d nearest = nearest_in_cone(problem.law, 0, 1, density);
  Eigen::Matrix2d expected;
  expected << -1, -1, 1, 1;
  EXPECT_LT((nearest - expected).cwiseAbs().maxCoeff(), 1e-12) << nearest;
}

RC_GTEST_PROP(AdmissibleTractions, are_in_the_cone, (Random random)) {
  const Problem problem = random_line(random, *rc::gen::arbitrary<bool>());
  const AdmissibleTractions result =
      admissible_tractions(problem.mesh, problem.line, problem.law, random_densities(problem.line.edge_count(), random),
                           Eigen::MatrixXd(problem.b.size(), 0));
  RC_ASSERT(cone_defect(problem.line, problem.law, result.densities) <= 1e-12);
}

RC_GTEST_PROP(AdmissibleTractions, are_those_of_the_cone_correction_where_it_suffices, (Random random)) {
  const Problem problem = random_line(random, false);
  ContactDensities computed = random_densities(problem.line.edge_count(), random);
  computed.normal = -computed.normal.cwiseAbs();
  computed.tangential = computed.tangential.cwiseProduct(problem.law.friction[0] * computed.normal);
  const AdmissibleTractions result =
      admissible_tractions(problem.mesh, problem.line, problem.law, computed, Eigen::MatrixXd(problem.b.size(), 0));
  RC_ASSERT(result.mended.empty());
  RC_ASSERT(result.densities.tangential == computed.tangential);
  RC_ASSERT(result.corrected_count() == 0);
}

RC_GTEST_PROP(AdmissibleTractions, shifts_change_no_nodal_balance, (Random random)) {
  const Problem problem = random_line(random, false);
  const AdmissibleTractions result =
      admissible_tractions(problem.mesh, problem.line, problem.law, random_densities(problem.line.edge_count(), random),
                           Eigen::MatrixXd(problem.b.size(), 0));
  RC_ASSERT(result.densities.normal == result.balanced.normal);
  const Eigen::RowVectorXd change =
      result.densities.tangential.colwise().sum() - result.balanced.tangential.colwise().sum();
  RC_ASSERT(change.cwiseAbs().maxCoeff() < 1e-14);
}

RC_GTEST_PROP(AdmissibleTractions, keep_the_resultants_on_motions_that_contact_alone_holds, (Random random)) {
  const Problem problem = random_line(random, *rc::gen::arbitrary<bool>());
  std::vector<char> prescribed(problem.b.size(), 0);
  for (Eigen::Index v = 0; v < problem.mesh.vertices.cols(); ++v) prescribed[2 * v] = 1;  // only y is free
  const Eigen::MatrixXd motions = free_rigid_motions(problem.mesh, prescribed);
  ContactDensities computed = random_densities(problem.line.edge_count(), random);
  computed.normal.array() -= 1;  // on the whole compressive
  const AdmissibleTractions result = admissible_tractions(problem.mesh, problem.line, problem.law, computed, motions);
  const auto resultant = [&](const ContactDensities& densities) -> Eigen::VectorXd {
    return motions.transpose() * nodal_forces(problem.mesh, problem.line, densities);
  };
  RC_ASSERT(result.resultants_kept);
  RC_ASSERT((resultant(result.densities) - resultant(computed)).norm() < 1e-10);
  RC_ASSERT(cone_defect(problem.line, problem.law, result.densities) <= 1e-12);
}

TEST(NodalForces, of_a_constant_traction_are_half_an_edge_each) {
  const Problem problem = body(rectangle(2, 1, 4, 1), material(1, 0));
  const ContactDensities densities{Eigen::Matrix2Xd::Constant(2, 2, -3), Eigen::Matrix2Xd::Constant(2, 2, 1)};
  const Eigen::VectorXd forces = nodal_forces(problem.mesh, problem.line, densities);
  EXPECT_LT((forces.head<6>() - (Eigen::VectorXd(6) << 1, 3, 2, 6, 1, 3).finished()).norm(), 1e-14);
  EXPECT_TRUE(forces.tail(6).isZero(0));
}

}  // namespace
}  // namespace ffcontact
