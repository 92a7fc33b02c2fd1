// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/matrix_free/product_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/any_step.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The relation of a problem by products.
ProductRelation by_products(const SolidProblem& problem,
                            const SurfaceTrace& trace) {
  const ElasticSystem system = problem.system();
  ProductRelation relation =
      product_relation(trace, system,
                       std::make_shared<const CondensedStiffness>(
                           system, trace.trace.kept_dofs, Precision::full,
                           SchurStorage::distributed));
  put_loads(problem.b, trace.trace.v_prescribed, relation);  // of AnyStep
  return relation;
}

/// Whatever the states: four digits a step towards what dense algebra finds.
RC_GTEST_PROP(ProductStep, gains_four_digits_a_step, (Random random)) {
  const SolidProblem problem = random_block(*real(0, 2), random);
  const AnyStep any(problem, random);
  const ProductRelation relation = by_products(problem, any.trace);
  const ContactRows exact = any.exact();
  ContactRows rows = any.rows;
  double missed = (rows.v - exact.v).norm();
  const double size = any.size_of(exact) + missed;
  for (int k = 0; k < 3; ++k) {
    const ProductStep step =
        solve_product_step(relation, any.equations(), rows);
    RC_ASSERT(step.kind == SystemKind::regular);
    const double left = (rows.v - exact.v).norm();
    RC_ASSERT(left <= 0.05 * missed + 1e-12 * size);
    missed = left;
  }
  RC_ASSERT((rows.P - exact.P).norm() <=
            1e-9 * size * any.contact.S.diagonal().maxCoeff());
}

/// Products of a step where all nodes slip without friction; the upper side is held.
int products_of_a_step(SolidMesh mesh, const std::vector<int>& labels) {
  SolidProblem problem(mesh, 0, labels);
  for (int v : vertices_on(mesh, high_z))
    for (int c = 0; c < 3; ++c) problem.prescribe(v, c, 0);
  problem.load(high_x, {1, 2, 3});
  const SurfaceTrace trace =
      surface_trace(problem.surface, problem.law, problem.system());
  const ProductRelation relation = by_products(problem, trace);
  const NaturalMap map(relation.blocks.diagonal(), relation.position,
                       trace.held);
  NodeState slips;
  slips.slips = true;
  const std::vector<NodeState> states(problem.surface.node_count(), slips);
  ContactRows rows{VectorXd::Zero(relation.row_count()),
                   VectorXd::Zero(relation.row_count())};
  return solve_product_step(relation, {trace.held, map, states}, rows).products;
}

SolidMesh brick_of(int n) { return brick({2 * n, n, 1}, {80, 40, 40}); }

/// On an inclined plane axes of aggregates and known components are not apart.
SolidMesh inclined(SolidMesh mesh) {
  const Eigen::AngleAxisd turn(0.4, Vector3d(1, 2, 0.5).normalized());
  mesh.vertices = turn.toRotationMatrix() * mesh.vertices;
  return mesh;
}

/// On four times as many nodes steps of GMRES are 5 or 6 more, of some 30. By vertices
/// alone they are more and grow; so do they on an edge, where rows depend on others,
/// without what their multipliers make of the rest.
TEST(ProductStep, steps_of_gmres_hardly_grow_with_the_number_of_nodes) {
  const auto plane = [](int n) {
    return products_of_a_step(brick_of(n), {low_z});
  };
  const auto inclined_plane = [](int n) {
    return products_of_a_step(inclined(brick_of(n)), {low_z});
  };
  const auto edge = [](int n) {
    return products_of_a_step(brick_of(n), {low_x, low_z});
  };
  EXPECT_LE(plane(18), plane(9) + 8);
  EXPECT_LE(inclined_plane(18), inclined_plane(9) + 8);
  EXPECT_LE(edge(18), edge(9) + 8);
}

}  // namespace
}  // namespace ffcontact
