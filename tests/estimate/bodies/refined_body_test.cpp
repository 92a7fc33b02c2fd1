// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/refined_body.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/law/friction_cone.hpp"
#include "support/cut_bodies.hpp"
#include "support/estimates.hpp"
#include "support/initial_stress.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

SolvedBody<2> random_body(const CutBodies& cut, std::mt19937& random) {
  const Problem& problem = cut.two.problem;
  const Index nodes = problem.line.node_count();
  SolvedBody<2> body;
  body.hooke = problem.hooke;
  body.displacement = random_vector(problem.A.rows(), random);
  body.multipliers = random_matrix(2, nodes, random);
  body.law.multiplier = Multiplier::pressure;
  body.law.friction = random_vector(nodes, random);
  body.law.gap = random_vector(nodes, random);
  body.neumann = random_matrix(4, problem.mesh.boundary.cols(), random);
  body.body_loads = random_matrix(6, problem.mesh.cells.cols(), random);
  return body;
}

SolvedBody<2> refined(const CutBodies& cut, const SolvedBody<2>& old) {
  const Problem& problem = cut.two.problem;
  return refined_body(problem.mesh, problem.edges, problem.line, old,
                      cut.refinement);
}

/// Bounds of the coefficient that are linear between nodal values stay so.
RC_GTEST_PROP(RefinedBody, has_the_bounds_of_the_law_on_the_parts_of_edges,
              (Random random)) {
  const CutBodies cut(random);
  const ContactLine &line = cut.two.problem.line, &parts = cut.refinement.line;
  SolvedBody<2> old = random_body(cut, random);
  old.law.friction = old.law.friction.cwiseAbs();
  for (Matrix2Xd* bound :
       {&old.law.between_nodes.least, &old.law.between_nodes.most}) {
    bound->resize(2, line.edge_count());
    for (int e = 0; e < line.edge_count(); ++e)
      for (int end = 0; end < 2; ++end)
        (*bound)(end, e) = old.law.friction[line.edge_node(end, e)];
  }
  old.law.shear_limit = old.law.friction;
  old.law.limit_between_nodes = old.law.between_nodes;
  const ContactLaw<2> law = refined(cut, old).law;
  for (int e = 0; e < parts.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) {
      const double expected = law.friction[parts.edge_node(end, e)];
      for (const auto& cones :
           {least_cones(parts, law, e), most_cones(parts, law, e)}) {
        RC_ASSERT(std::abs(cones[end].friction - expected) < 1e-13);
        RC_ASSERT(std::abs(cones[end].limit - expected) < 1e-13);
      }
    }
}

RC_GTEST_PROP(RefinedBody, has_the_stresses_of_the_old_triangles,
              (Random random)) {
  const CutBodies cut(random);
  const SolvedBody<2> old = random_body(cut, random), body = refined(cut, old);
  const Matrix3Xd before = stresses(cut.mesh(), old.hooke, old.displacement);
  const Matrix3Xd after =
      stresses(cut.refinement.mesh, body.hooke, body.displacement);
  for (int t = 0; t < cut.refinement.mesh.cell_count(); ++t) {
    const double rounding = 1e-12 *
                            hat_gradients(cut.refinement.mesh, t).norm() *
                            old.displacement.norm() * old.hooke[0].norm();
    RC_ASSERT((after.col(t) - before.col(cut.refinement.parent[t])).norm() <
              rounding);
  }
}

/// Nodal values on the refinement at the places of the old contact edges that its nodes
/// lie between.
double interpolated(const CutBodies& cut, const VectorXd& values, int node) {
  double sum = 0;
  for (WeightsByNode::InnerIterator part(cut.refinement.node_weights, node);
       part; ++part)
    sum += part.value() * values[part.col()];
  return sum;
}

RC_GTEST_PROP(RefinedBody, has_pressures_and_law_linear_between_the_old_nodes,
              (Random random)) {
  const CutBodies cut(random);
  const SolvedBody<2> old = random_body(cut, random), body = refined(cut, old);
  RC_ASSERT(body.law.multiplier == Multiplier::pressure);
  RC_ASSERT(body.law.slip_bound.size() == 0 && body.law.previous.size() == 0);
  for (int node = 0; node < cut.refinement.line.node_count(); ++node) {
    RC_ASSERT(std::abs(body.law.friction[node] -
                       interpolated(cut, old.law.friction, node)) < 1e-14);
    RC_ASSERT(std::abs(body.law.gap[node] -
                       interpolated(cut, old.law.gap, node)) < 1e-14);
    for (int c = 0; c < 2; ++c)
      RC_ASSERT(std::abs(body.multipliers(c, node) -
                         interpolated(cut, old.multipliers.row(c), node)) <
                1e-14);
  }
}

RC_GTEST_PROP(RefinedBody, has_the_initial_stress_of_the_old_triangles,
              (Random random)) {
  const CutBodies cut(random);
  SolvedBody<2> old = random_body(cut, random);
  RC_ASSERT(refined(cut, old).initial.empty());
  const MatrixXd slopes = random_matrix(3, 2, random);
  const Vector3d at_origin = random_vector(3, random);
  const auto tau = [&](const Vector2d& x) -> Vector3d {
    return at_origin + slopes * x;
  };
  old.initial = at_vertices(cut.mesh(), tau);
  const LinearStresses<2> expected = at_vertices(cut.refinement.mesh, tau),
                          found = refined(cut, old).initial;
  for (int t = 0; t < cut.refinement.mesh.cell_count(); ++t)
    RC_ASSERT((found.at_vertices(t) - expected.at_vertices(t)).norm() <
              1e-12 * (1 + slopes.norm()) *
                  cut.mesh().vertices.cwiseAbs().maxCoeff());
}

RC_GTEST_PROP(RefinedBody, carries_its_loads_on, (Random random)) {
  const CutBodies cut(random);
  const SolvedBody<2> old = random_body(cut, random), body = refined(cut, old);
  for (int c = 0; c < 2; ++c) {
    const auto resultant = [c](const auto& loads) {
      double sum = 0;
      for (Index row = c; row < loads.rows(); row += 2)
        sum += loads.row(row).sum();
      return sum;
    };
    RC_ASSERT(std::abs(resultant(body.neumann) - resultant(old.neumann)) <
              1e-12 * old.neumann.norm());
    RC_ASSERT(std::abs(resultant(body.body_loads) - resultant(old.body_loads)) <
              1e-12 * old.body_loads.norm());
  }
}

RC_GTEST_PROP(RefinedPrescribed,
              holds_a_new_vertex_where_both_ends_of_its_edge_are_held,
              (Random random)) {
  const CutBodies cut(random);
  std::vector<char> old(2 * cut.mesh().vertex_count());
  for (char& dof : old) dof = static_cast<char>(random() % 2);
  const std::vector<char> prescribed = refined_prescribed(cut.refinement, old);
  RC_ASSERT(cut.refinement.mesh.vertex_count() > cut.mesh().vertex_count());
  for (int v = 0; v < cut.refinement.mesh.vertex_count(); ++v)
    for (int c = 0; c < 2; ++c) {
      int held = 0, ends = 0;
      for (WeightsByNode::InnerIterator part(cut.refinement.vertex_weights, v);
           part; ++part, ++ends)
        held += old[2 * part.col() + c];
      RC_ASSERT(ends == (v < cut.mesh().vertex_count() ? 1 : 2));
      RC_ASSERT((prescribed[2 * v + c] == 1) == (held == ends));
    }
}

RC_GTEST_PROP(UnrefinedForces, do_the_same_work, (Random random)) {
  const CutBodies cut(random);
  const SolvedBody<2> old = random_body(cut, random);
  const VectorXd fine = refined(cut, old).displacement;
  const VectorXd forces = random_vector(fine.size(), random);
  const double work =
      unrefined_forces(cut.refinement, forces).dot(old.displacement);
  RC_ASSERT(std::abs(work - forces.dot(fine)) <
            1e-12 * forces.norm() * fine.norm());
}

}  // namespace
}  // namespace ffcontact
