// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/schur_solver.hpp"

#include <gtest/gtest.h>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A brick condensed to its lower face; its top is held, or nothing.
struct Condensed {
  ElasticSystem system;
  std::vector<int> kept;
  MatrixXd motions;  ///< on the kept dofs
  CondensedStiffness stiffness;
  MatrixXd S;

  Condensed(const SolidMesh& mesh, bool held, Precision precision)
      : system(system_of(mesh, held)),
        kept(free_dofs_at(vertices_on(mesh, low_z), system)),
        motions(free_rigid_motions(mesh, system.prescribed)(kept, Eigen::all)),
        stiffness(system, kept, precision),
        S(stiffness.schur()) {}

  static ElasticSystem system_of(const SolidMesh& mesh, bool held) {
    RowMatrix A = ffcontact::stiffness(
        mesh, HookeTensors<3>(mesh.cell_count(), isotropic<3>(60, 40)));
    if (held)
      for (int v : vertices_on(mesh, high_z))
        for (int dof = 3 * v; dof < 3 * v + 3; ++dof)
          A.coeffRef(dof, dof) = 1e30;
    return elastic_system(A, VectorXd::Zero(A.rows()), 3);
  }

  /// |(S + s Z Z') x - g| / |g|
  double residual(const VectorXd& x, const VectorXd& g) const {
    VectorXd left = S * x - g;
    if (motions.cols() > 0)
      left += S.diagonal().mean() / motions.colwise().squaredNorm().mean() *
              motions * (motions.transpose() * x);
    return left.norm() / g.norm();
  }
};

/// Exactly, or to what conjugate gradients are asked for.
RC_GTEST_PROP(SchurSolver, solves, (Random random)) {
  const bool held = *rc::gen::arbitrary<bool>(),
             full = *rc::gen::arbitrary<bool>();
  const Condensed body(irregular_solid(random), held,
                       full ? Precision::full : Precision::single);
  const SchurSolver solver(body.system, body.kept, body.stiffness,
                           body.motions);
  for (int load = 0; load < 2; ++load) {
    const VectorXd g = random_vector(count_of(body.kept), random);
    RC_ASSERT(body.residual(solver.solve(g), g) < (full ? 1e-10 : 1.1e-5));
  }
}

/// By the diagonal alone they are more and grow.
TEST(SchurSolver, steps_do_not_grow_with_the_number_of_dofs) {
  std::mt19937 random;
  for (int n : {5, 10})
    for (bool held : {true, false}) {
      const Condensed body(brick({2 * n, 2 * n, n}, {2, 2, 1}), held,
                           Precision::single);
      const SchurSolver solver(body.system, body.kept, body.stiffness,
                               body.motions, 40);
      const VectorXd g = random_vector(count_of(body.kept), random);
      EXPECT_GT(body.residual(solver.solve(g), g), 1e-10);  // not by a factor
    }
}

/// A factor is exact.
TEST(SchurSolver, factors_where_steps_are_not_enough) {
  for (bool held : {true, false}) {
    const Condensed body(brick({4, 4, 2}, {2, 2, 1}), held, Precision::single);
    const VectorXd g =
        VectorXd::LinSpaced(count_of(body.kept), 0, count_of(body.kept));
    const auto residual = [&](int most_steps) {
      const SchurSolver solver(body.system, body.kept, body.stiffness,
                               body.motions, most_steps);
      return body.residual(solver.solve(g), g);
    };
    EXPECT_GT(residual(100), 1e-10);
    EXPECT_LT(residual(3), 1e-12);
  }
}

}  // namespace
}  // namespace ffcontact
