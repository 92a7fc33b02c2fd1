// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/refined_moments.hpp"

#include <gtest/gtest.h>

#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "support/cells.hpp"
#include "support/cut_bodies.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A quadratic stress and the linear body force f = a + J x that it balances, with their
/// exact integrals on any mesh.
struct QuadraticStress {
  Vector3d constant;
  Vector2d a;
  Matrix2d J;

  explicit QuadraticStress(std::mt19937& random)
      : constant(random_vector(3, random)),
        a(random_vector(2, random)),
        J(random_matrix(2, 2, random)) {}

  Vector2d force(const Vector2d& x) const { return a + J * x; }
  Vector3d stress(const Vector2d& x) const {
    const double xx =
        a.x() * x.x() + J(0, 0) * x.x() * x.x() / 2 + J(0, 1) * x.x() * x.y();
    const double yy =
        a.y() * x.y() + J(1, 1) * x.y() * x.y() / 2 + J(1, 0) * x.x() * x.y();
    return constant - Vector3d(xx, yy, 0);
  }

  /// By Simpson's rule, which is exact.
  EdgeMoments moments(const Mesh& mesh, const Edges& edges) const {
    EdgeMoments result(4, edges.count());
    for (int e = 0; e < edges.count(); ++e) {
      const Vector2d start = mesh.vertices.col(edges.vertices(0, e)),
                     side = edge_vector(mesh, edges, e);
      const auto at = [&](double s) {
        return traction(stress(start + s * side), edge_normal(mesh, edges, e));
      };
      result.col(e) << at(0) + 2 * at(0.5), 2 * at(0.5) + at(1);
      result.col(e) *= side.norm() / 6;
    }
    return result;
  }
  BodyLoadsOfCells<2> body_loads(const Mesh& mesh) const {
    BodyLoadsOfCells<2> result(6, mesh.cells.cols());
    for (int t = 0; t < mesh.cell_count(); ++t) {
      Matrix<double, 2, 3> F;
      for (int k = 0; k < 3; ++k) F.col(k) = force(mesh.corner(t, k));
      result.col(t) = (signed_area(mesh, t) / 12 *
                       (F + F.rowwise().sum().replicate<1, 3>()))
                          .reshaped();
    }
    return result;
  }
  Matrix3Xd at_centroids(const Mesh& mesh) const {
    Matrix3Xd result(3, mesh.cells.cols());
    for (int t = 0; t < mesh.cell_count(); ++t)
      result.col(t) = stress(corners_of(mesh, t).rowwise().mean());
    return result;
  }
  /// What the whole boundary carries.
  BoundaryTractions tractions(const Mesh& mesh, const Edges& edges) const {
    BoundaryTractions result;
    result.known.setConstant(2, edges.count(), true);
    result.moments = moments(mesh, edges);
    return result;
  }
};

EdgeMoments refined(const CutBodies& cut, const QuadraticStress& field) {
  return refined_moments(
      cut.edges(), cut.refinement, field.moments(cut.mesh(), cut.edges()),
      field.at_centroids(cut.mesh()), field.body_loads(cut.refinement.mesh),
      field.tractions(cut.refinement.mesh, cut.refinement.edges));
}

RC_GTEST_PROP(RefinedMoments, balance_every_triangle_in_force_and_moment,
              (Random random)) {
  const CutBodies cut(random);
  const QuadraticStress field(random);
  const Mesh& mesh = cut.refinement.mesh;
  const EdgeMoments moments = refined(cut, field);
  const BodyLoadsOfCells<2> in_body = field.body_loads(mesh);
  RC_ASSERT(mesh.cell_count() > cut.mesh().cell_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    RC_ASSERT(
        out_of_balance<2>(corners_of(mesh, t),
                          loads_of<2>(mesh, cut.refinement.edges, moments, t),
                          in_body.col(t).reshaped(2, 3))
            .norm() < 1e-10 * moments.cwiseAbs().maxCoeff());
}

RC_GTEST_PROP(RefinedMoments, on_parts_of_old_edges_are_the_given_ones,
              (Random random)) {
  const CutBodies cut(random);
  const QuadraticStress field(random);
  const EdgeMoments moments = refined(cut, field),
                    exact = field.moments(cut.refinement.mesh,
                                          cut.refinement.edges);
  for (int e = 0; e < cut.refinement.edges.count(); ++e)
    if (cut.refinement.parent_edge[e] >= 0)
      RC_ASSERT((moments.col(e) - exact.col(e)).norm() < 1e-12 * exact.norm());
}

RC_GTEST_PROP(RefinedMoments,
              of_a_constant_stress_are_its_tractions_inside_the_fans,
              (Random random)) {
  const CutBodies cut(random);
  QuadraticStress field(random);
  field.a.setZero();
  field.J.setZero();
  const EdgeMoments moments = refined(cut, field),
                    exact = field.moments(cut.refinement.mesh,
                                          cut.refinement.edges);
  RC_ASSERT((cut.refinement.parent_edge.array() < 0).any());
  RC_ASSERT((moments - exact).norm() < 1e-12 * exact.norm());
}

RC_GTEST_PROP(TractionsOfParts,
              are_the_moments_on_the_old_contact_edges_and_those_they_face,
              (Random random)) {
  const CutBodies cut(random);
  const QuadraticStress field(random);
  BoundaryTractions before;
  before.known.setConstant(2, cut.edges().count(), false);
  before.moments = random_matrix(4, cut.edges().count(), random);
  const BoundaryTractions after = tractions_of_parts(
      cut.edges(), cut.refinement,
      field.tractions(cut.refinement.mesh, cut.refinement.edges), before);
  std::vector<char> in_contact(cut.edges().count(), 0);
  for (int e : cut.line().edge) in_contact[e] = 1;
  for (int e : cut.refinement.line.opposite_edge)
    if (e >= 0) in_contact[cut.refinement.parent_edge[e]] = 1;
  const EdgeMoments exact = field.moments(cut.mesh(), cut.edges());
  for (int e = 0; e < cut.edges().count(); ++e) {
    RC_ASSERT(after.known(0, e) == (in_contact[e] == 1) &&
              after.known(1, e) == (in_contact[e] == 1));
    const EdgeMoments& expected = in_contact[e] ? exact : before.moments;
    RC_ASSERT((after.moments.col(e) - expected.col(e)).norm() <
              1e-12 * expected.norm());
  }
}

RC_GTEST_PROP(RefinedBodyLoads, are_those_of_the_linear_force_of_the_old_ones,
              (Random random)) {
  const CutBodies cut(random);
  const QuadraticStress field(random);
  const BodyLoadsOfCells<2> loads = refined_body_loads(
      cut.mesh(), cut.refinement, field.body_loads(cut.mesh()));
  RC_ASSERT(relative_difference(loads, field.body_loads(cut.refinement.mesh)) <
            1e-12);
}

/// Moments of linear tractions on the columns of Mesh::boundary.
Matrix4Xd moments_of_tractions(const Mesh& mesh, const QuadraticStress& field) {
  Matrix4Xd moments(4, mesh.boundary.cols());
  for (Index b = 0; b < mesh.boundary.cols(); ++b) {
    const Vector2d first = mesh.vertices.col(mesh.boundary(0, b)),
                   second = mesh.vertices.col(mesh.boundary(1, b));
    Matrix2d density;
    density << field.force(first), field.force(second);
    moments.col(b) =
        facet_moments_of<2>(density, (second - first).norm()).reshaped();
  }
  return moments;
}

RC_GTEST_PROP(RefinedBoundaryMoments,
              are_those_of_the_linear_tractions_of_the_old_ones,
              (Random random)) {
  const CutBodies cut(random);
  const QuadraticStress field(random);
  const Matrix4Xd moments = refined_boundary_moments(
      cut.mesh(), cut.refinement, moments_of_tractions(cut.mesh(), field));
  RC_ASSERT(relative_difference(
                moments, moments_of_tractions(cut.refinement.mesh, field)) <
            1e-12);
}

}  // namespace
}  // namespace ffcontact
