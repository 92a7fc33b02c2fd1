// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/local_mending.hpp"

#include "support/cases.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Compressive densities, continuous along the line, with single tensile nodes.
struct RandomDensities {
  Problem problem;
  ContactDensities computed;

  explicit RandomDensities(Random& random)
      : problem(body(irregular(*rc::gen::inRange(12, 24), 3, 12, 2, random),
                     material(1000, 0.3))) {
    set_friction(problem, *rc::gen::element(0.0, 1e-3, 0.3));
    if (*rc::gen::arbitrary<bool>())
      problem.law.slip_bound = everywhere(problem.line, 0.4);
    Matrix2Xd pressure = random_matrix(2, problem.line.node_count(), random);
    pressure.row(0).array() -= 3;
    pressure.row(1) *= problem.law.tresca() ? 0.4 : 3 * problem.law.friction[0];
    for (int k = 0; k < 2; ++k)
      pressure(0, *rc::gen::inRange(1, problem.line.node_count() - 1)) = 0.2;
    computed = edge_densities(problem.line, pressure);
  }
};

/// Force and moment about x = 0 of the change of one edge on the line y = 0.
Vector3d resultants_of(const RandomDensities& c, const ContactDensities& densities,
                       int e) {
  const Vector2d n = densities.normal.col(e) - c.computed.normal.col(e);
  const Vector2d t = densities.tangential.col(e) - c.computed.tangential.col(e);
  const double l = c.problem.line.length[e],
               x = c.problem.mesh.vertices(0, c.problem.line.vertex[e]);
  return {l * t.sum() / 2, -l * n.sum() / 2,
          -l * (x * n.sum() / 2 + l * (n[0] + 2 * n[1]) / 6)};
}

RC_GTEST_PROP(LocalMending, is_in_the_cone_and_keeps_force_and_moment_of_every_window,
              (Random random)) {
  const RandomDensities c(random);
  const auto mending =
      mend_locally(c.problem.mesh, c.problem.line, c.problem.law, c.computed);
  RC_ASSERT(mending.has_value());
  RC_ASSERT(cone_defect(c.problem.line, c.problem.law, mending->tractions.densities) <=
            1e-12);
  RC_ASSERT(!mending->windows.empty());
  for (const LineWindow& window : mending->windows) {
    RC_ASSERT(window.count() <= 16);
    Vector3d resultant = Vector3d::Zero();
    for (int e = window.first; e <= window.last; ++e)
      resultant += resultants_of(c, mending->tractions.balanced, e);
    RC_ASSERT(resultant.norm() < 1e-11);
  }
}

RC_GTEST_PROP(LocalMending, stresses_balance_the_change_of_forces_at_every_vertex,
              (Random random)) {
  const RandomDensities c(random);
  const Mesh& mesh = c.problem.mesh;
  const auto mending = mend_locally(mesh, c.problem.line, c.problem.law, c.computed);
  RC_ASSERT(mending.has_value());
  Matrix3Xd added = Matrix3Xd::Zero(3, mesh.cells.cols());
  add_balancing_stresses(mesh, stars_of(mesh, c.problem.edges), c.problem.hooke,
                         c.problem.line, c.computed, *mending, added);
  VectorXd left_over = nodal_forces(mesh, c.problem.line, c.computed) -
                       nodal_forces(mesh, c.problem.line, mending->tractions.balanced);
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k)
      left_over.segment<2>(2 * mesh.cells(k, t)) +=
          signed_area(mesh, t) * traction(added.col(t), hat_gradients(mesh, t).col(k));
  RC_ASSERT(left_over.cwiseAbs().maxCoeff() < 1e-10);
}

TEST(LocalMending, changes_nothing_where_correction_41_suffices) {
  const Problem problem = body(rectangle(4, 1, 4, 1), material(1, 0));
  const ContactDensities computed{Matrix2Xd::Constant(2, 4, -1), Matrix2Xd::Zero(2, 4)};
  const auto mending = mend_locally(problem.mesh, problem.line, problem.law, computed);
  ASSERT_TRUE(mending.has_value());
  EXPECT_TRUE(mending->windows.empty());
  EXPECT_EQ(mending->tractions.densities.normal, computed.normal);
}

TEST(LocalMending, is_nothing_where_the_force_is_tensile) {
  const Problem problem = body(rectangle(4, 1, 4, 1), material(1, 0));
  const ContactDensities computed{Matrix2Xd::Constant(2, 4, 1), Matrix2Xd::Zero(2, 4)};
  EXPECT_FALSE(
      mend_locally(problem.mesh, problem.line, problem.law, computed).has_value());
}

}  // namespace
}  // namespace ffcontact
