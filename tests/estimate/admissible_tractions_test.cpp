// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/admissible_tractions.hpp"

#include <gtest/gtest.h>

#include "ffcontact/elastic/rigid_motions.hpp"
#include "support/problems.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

ContactDensities random_densities(Index edges, Random& random) {
  return {random_matrix(2, edges, random).array() - 0.5, random_matrix(2, edges, random)};
}

Problem random_line(Random& random, bool tresca) {
  Problem problem = body(irregular(6, 2, 6, 2, random), material(1, 0));
  set_friction(problem, *real(0, 1));
  if (tresca) problem.law.slip_bound = everywhere(problem.line, *real(0, 1));
  return problem;
}

/// Nodal pressures of the law.
Matrix2Xd pressures_inside(const Problem& problem, Random& random) {
  Matrix2Xd p = random_matrix(2, problem.line.node_count(), random);
  p.row(0) = -p.row(0).cwiseAbs();
  for (int i = 0; i < p.cols(); ++i) {
    const double bound = problem.law.tresca() ? problem.law.slip_bound[i]
                                              : -problem.law.friction[i] * p(0, i);
    p(1, i) = std::clamp(p(1, i), -bound, bound);
  }
  return p;
}

AdmissibleTractions tractions_of(const Problem& problem, const ContactDensities& computed,
                                 Random& random) {
  const auto result = admissible_tractions(problem.mesh, problem.line, problem.law,
                                           computed, pressures_inside(problem, random),
                                           MatrixXd(problem.b.size(), 0), {});
  RC_ASSERT(result.has_value());
  return *result;
}

RC_GTEST_PROP(AdmissibleTractions, are_in_the_cone, (Random random)) {
  const Problem problem = random_line(random, *rc::gen::arbitrary<bool>());
  const ContactDensities computed = random_densities(problem.line.edge_count(), random);
  RC_ASSERT(cone_defect(problem.line, problem.law,
                        tractions_of(problem, computed, random).densities) <= 1e-12);
}

RC_GTEST_PROP(AdmissibleTractions, are_those_of_the_cone_correction_where_it_suffices,
              (Random random)) {
  const Problem problem = random_line(random, false);
  ContactDensities computed = random_densities(problem.line.edge_count(), random);
  computed.normal = -computed.normal.cwiseAbs();
  computed.tangential =
      computed.tangential.cwiseProduct(problem.law.friction[0] * computed.normal);
  const AdmissibleTractions result = tractions_of(problem, computed, random);
  RC_ASSERT(result.mended.empty());
  RC_ASSERT(result.densities.tangential == computed.tangential);
  RC_ASSERT(result.corrected_count() == 0);
}

RC_GTEST_PROP(AdmissibleTractions, shifts_change_no_nodal_balance, (Random random)) {
  const Problem problem = random_line(random, false);
  const AdmissibleTractions result =
      tractions_of(problem, random_densities(problem.line.edge_count(), random), random);
  RC_ASSERT(result.densities.normal == result.balanced.normal);
  const Eigen::RowVectorXd change = result.densities.tangential.colwise().sum() -
                                    result.balanced.tangential.colwise().sum();
  RC_ASSERT(change.cwiseAbs().maxCoeff() < 1e-14);
}

TEST(NodalForces, of_a_constant_traction_are_half_an_edge_each) {
  const Problem problem = body(rectangle(2, 1, 4, 1), material(1, 0));
  const ContactDensities densities{Matrix2Xd::Constant(2, 2, -3),
                                   Matrix2Xd::Constant(2, 2, 1)};
  const VectorXd forces = nodal_forces(problem.mesh, problem.line, densities);
  EXPECT_LT((forces.head<6>() - (VectorXd(6) << 1, 3, 2, 6, 1, 3).finished()).norm(),
            1e-14);
  EXPECT_TRUE(forces.tail(6).isZero(0));
}

}  // namespace
}  // namespace ffcontact
