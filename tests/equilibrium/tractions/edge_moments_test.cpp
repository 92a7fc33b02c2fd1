// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/edge_moments.hpp"

#include <gtest/gtest.h>

#include "support/balances.hpp"
#include "support/cases.hpp"
#include "support/estimates.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Largest force and moment left over on a triangle, relative to the largest moment of an
/// edge.
double imbalance(const Problem& problem, const Equilibrated& fields) {
  double worst = 0;
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    worst = std::max(
        worst, out_of_balance(corners_of(problem.mesh, t),
                              fields.difference.col(t), fields.loads.col(t))
                   .norm());
  return worst / fields.moments.cwiseAbs().maxCoeff();
}

RC_GTEST_PROP(EdgeMoments, balance_every_triangle_in_force_and_moment, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  RC_ASSERT(imbalance(problem, equilibrated(problem, solved(problem))) < 1e-9);
}

RC_GTEST_PROP(EdgeMoments, are_the_given_ones_where_these_are_known, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  const Equilibrated fields = equilibrated(problem, solved(problem));
  for (int e = 0; e < problem.edges.count(); ++e)
    for (int c = 0; c < 4; ++c)
      if (fields.boundary.known(c % 2, e))
        RC_ASSERT(fields.moments(c, e) == fields.boundary.moments(c, e));
}

RC_GTEST_PROP(EdgeMoments, of_a_constant_stress_are_its_tractions,
              (Random random)) {
  Problem problem = body(irregular(4, 3, 4, 3, random), material(1, 0.3));
  for (int label : {top, left, right}) clamp(problem, label);
  const Vector3d sigma = random_vector(3, random);
  const ContactLine& line = problem.line;
  ContactDensities densities{Matrix2Xd(2, line.edge_count()),
                             Matrix2Xd(2, line.edge_count())};
  for (int k = 0; k < line.edge_count(); ++k) {
    const Vector2d r = traction(sigma, line.edge_normal(k));
    densities.normal.col(k).setConstant(r.dot(line.edge_normal(k)));
    densities.tangential.col(k).setConstant(r.dot(line.edge_tangent(k)));
  }
  const BoundaryTractions boundary = boundary_tractions(
      problem.mesh, problem.edges, prescribed_dofs(problem.A), problem.neumann,
      line, densities);
  const Matrix3Xd stress = sigma.replicate(1, problem.mesh.cell_count());
  const EdgeMoments moments = equilibrated_moments(
      topology_of(problem.mesh), stress, body_loads(problem), boundary);
  for (int e = 0; e < problem.edges.count(); ++e) {
    const Vector2d F =
        traction(sigma, edge_normal(problem.mesh, problem.edges, e));
    const Vector4d density = density_of_moments(
        moments.col(e), edge_vector(problem.mesh, problem.edges, e).norm());
    RC_ASSERT((density - Vector4d(F.x(), F.y(), F.x(), F.y())).norm() < 1e-9);
  }
}

TEST(EdgeMoments, a_spoiled_moment_is_out_of_balance) {
  const Problem problem = example_1(Multiplier::force, 4);
  Equilibrated fields = equilibrated(problem, solved(problem));
  ASSERT_LT(imbalance(problem, fields), 1e-10);
  fields.moments(1, 7) += 1e-4 * fields.moments.cwiseAbs().maxCoeff();
  fields.difference = difference_loads(problem.mesh, problem.edges,
                                       fields.moments, fields.stress);
  EXPECT_GT(imbalance(problem, fields), 0.9e-4);
}

}  // namespace
}  // namespace ffcontact
