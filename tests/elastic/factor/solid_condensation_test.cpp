// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>

#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "support/free_displacement.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

struct Body {
  SolidMesh mesh;
  ElasticSystem system;
};

/// A loaded brick whose top is moved, or that nothing holds.
Body random_body(bool held, Random& random) {
  const SolidMesh mesh = irregular_solid(random);
  RowMatrix A =
      stiffness(mesh, HookeTensors<3>(mesh.cell_count(), isotropic<3>(60, 40)));
  VectorXd b = random_vector(A.rows(), random);
  if (held)
    for (int v : vertices_on(mesh, high_z))
      for (int dof = 3 * v; dof < 3 * v + 3; ++dof) {
        A.coeffRef(dof, dof) = 1e30;
        b[dof] = 1e30 * 0.01 * mesh.vertices(0, v);
      }
  return {mesh, elastic_system(A, b, 3)};
}

/// All dofs of the vertices below, which hold the body, and single ones of others, in
/// random order.
std::vector<int> random_kept(const Body& body, Random& random) {
  std::vector<int> kept;
  for (int v : vertices_on(body.mesh, low_z))
    for (int dof = 3 * v; dof < 3 * v + 3; ++dof) kept.push_back(dof);
  for (int dof : free_dofs(body.system))
    if (random() % 10 == 0 &&
        std::find(kept.begin(), kept.end(), dof) == kept.end())
      kept.push_back(dof);
  kept.erase(
      std::remove_if(kept.begin(), kept.end(),
                     [&](int dof) { return body.system.prescribed[dof]; }),
      kept.end());
  shuffle(kept, random);
  return kept;
}

double largest(const Ref<const MatrixXd>& values) {
  return values.cwiseAbs().maxCoeff();
}

RC_GTEST_PROP(SolidCondensation,
              is_the_inverse_of_the_dense_inverse_at_the_kept_dofs,
              (Random random)) {
  const Body body = random_body(true, random);
  const std::vector<int> kept = random_kept(body, random),
                         dofs = free_dofs(body.system);
  const CondensedStiffness condensed(body.system, kept);
  const MatrixXd inverse =
      MatrixXd(body.system.stiffness)(dofs, dofs).inverse();
  std::vector<int> places;
  for (int dof : kept)
    places.push_back(static_cast<int>(std::find(dofs.begin(), dofs.end(), dof) -
                                      dofs.begin()));
  const MatrixXd flexibility = inverse(places, places);
  const MatrixXd product = condensed.schur() * flexibility;
  RC_ASSERT(largest(product - MatrixXd::Identity(product.rows(),
                                                 product.cols())) < 1e-10);
  // S u_c = g for the u_c of the whole solution
  const VectorXd u = inverse * body.system.load(dofs);
  const VectorXd g = condensed.condensed(body.system.load).on_kept;
  RC_ASSERT(largest(condensed.schur() * u(places) - g) < 1e-10 * largest(g));
}

RC_GTEST_PROP(SolidCondensation, solves_as_the_whole_system_does,
              (Random random)) {
  const Body body = random_body(true, random);
  const std::vector<int> kept = random_kept(body, random);
  const VectorXd whole =
      displacement(body.system) - body.system.prescribed_value;
  const CondensedStiffness condensed(body.system, kept);
  const CondensedStiffness::Load load = condensed.condensed(body.system.load);
  const VectorXd u_c = condensed.schur().partialPivLu().solve(load.on_kept);
  const VectorXd u = condensed.extended(load, u_c);
  RC_ASSERT(largest(u - whole) < 1e-11 * largest(whole));
  const std::vector<int> dofs = free_dofs(body.system);
  const VectorXd residual = body.system.stiffness * whole - body.system.load;
  RC_ASSERT(largest(residual(dofs)) < 1e-12 * largest(body.system.load));
}

RC_GTEST_PROP(SolidCondensation,
              of_a_floating_body_keeps_exactly_the_rigid_motions,
              (Random random)) {
  const Body body = random_body(false, random);
  const std::vector<int> kept = random_kept(body, random);
  const MatrixXd S = CondensedStiffness(body.system, kept).schur();
  const MatrixXd motions =
      free_rigid_motions(body.mesh, body.system.prescribed)(kept, Eigen::all);
  RC_ASSERT(motions.cols() == 6);
  RC_ASSERT(largest(S * motions) < 1e-11 * largest(S));
  RC_ASSERT(Eigen::FullPivLU<MatrixXd>(S).setThreshold(1e-10).rank() ==
            static_cast<Index>(kept.size()) - 6);
}

TEST(SolidCondensation, fails_where_the_kept_dofs_do_not_hold_the_body) {
  Random random(4);
  const Body body = random_body(false, random);
  const int v = vertices_on(body.mesh, low_z)[0];
  EXPECT_THROW(CondensedStiffness(body.system, {3 * v, 3 * v + 1, 3 * v + 2}),
               std::runtime_error);
}

}  // namespace
}  // namespace ffcontact
