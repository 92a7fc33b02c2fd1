// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/equilibrated_moments.hpp"

#include <gtest/gtest.h>

#include "support/cases.hpp"
#include "support/cells.hpp"
#include "support/estimates.hpp"
#include "support/loaded_solid.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Largest force and moment left over on a triangle, relative to the largest moment of an
/// edge.
double imbalance(const Problem& problem, const Equilibrated& fields) {
  double worst = 0;
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    worst = std::max(
        worst, out_of_balance<2>(
                   corners_of(problem.mesh, t),
                   difference_loads<2>(fields.difference(), fields.moments, t),
                   fields.loads.col(t).reshaped(2, 3))
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
    const Matrix2d density =
        facet_density<2>(moments.col(e).reshaped(2, 2),
                         facet_measure(problem.mesh, problem.edges, e));
    RC_ASSERT((density.colwise() - F).norm() < 1e-9);
  }
}

/// Those around a vertex inside leave one number a component free: what a force adds that
/// goes around it. It is such that stresses beside long edges of small triangles do not
/// grow: the sum of (z - z_0) (areas beside the edge) / length^2 around it is 0.
RC_GTEST_PROP(EdgeMoments, are_nearest_to_the_mean_in_stresses,
              (Random random)) {
  Problem problem = body(irregular(5, 4, 50, 4, random), material(1, 0.3));
  for (int label : {top, left, right}) clamp(problem, label);
  const int contacts = problem.line.edge_count();
  const BoundaryTractions boundary = boundary_tractions(
      problem.mesh, problem.edges, prescribed_dofs(problem.A), problem.neumann,
      problem.line,
      {Matrix2Xd::Zero(2, contacts), Matrix2Xd::Zero(2, contacts)});
  const Topology<2> topology = topology_of(problem.mesh);
  const Edges& edges = topology.facets;
  const Matrix3Xd stress = random_matrix(3, problem.mesh.cell_count(), random);
  const EdgeMoments moments =
      equilibrated_moments(topology, stress, body_loads(problem), boundary);
  for (int v = 0; v < topology.ridges.count(); ++v) {
    if (topology.ridges.on_boundary[v]) continue;
    Vector2d sum = Vector2d::Zero(), terms = sum;
    for (int e : topology.ridges.facets_of(v)) {
      const int t = edges.cells(0, e), other = edges.cells(1, e);
      const double length = facet_measure(topology.mesh, edges, e),
                   beside = signed_area(topology.mesh, t) +
                            signed_area(topology.mesh, other);
      const Vector2d off = moments.col(e).segment<2>(2 * edges.place_of(v, e)) -
                           length / 2 *
                               traction((stress.col(t) + stress.col(other)) / 2,
                                        edge_normal(topology.mesh, edges, e));
      const Vector2d term = off * beside / (length * length);
      sum += edges.vertices(1, e) == v ? term : (-term).eval();
      terms += term.cwiseAbs();
    }
    RC_ASSERT(sum.norm() < 1e-9 * terms.norm());
  }
}

TEST(EdgeMoments, a_spoiled_moment_is_out_of_balance) {
  const Problem problem = example_1(Multiplier::force, 4);
  Equilibrated fields = equilibrated(problem, solved(problem));
  ASSERT_LT(imbalance(problem, fields), 1e-10);
  fields.moments(1, 7) += 1e-4 * fields.moments.cwiseAbs().maxCoeff();
  EXPECT_GT(imbalance(problem, fields), 0.9e-4);
}

/// Largest force or moment over size that is left on a tetrahedron, and largest value.
struct SolidBalance {
  double left = 0, largest = 0;
};

SolidBalance balance_of(const LoadedSolid& body, const FaceMoments& moments) {
  const auto& [mesh, faces, edges, stars] = body.topology;
  SolidBalance balance;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const FacetLoads<3> loads = loads_of(mesh, faces, moments, t);
    const CellBodyLoads<3> in_body = body.body_loads.col(t).reshaped(3, 4);
    const auto out = out_of_balance<3>(corners_of(mesh, t), loads, in_body);
    balance.left = std::max(balance.left, out.cwiseAbs().maxCoeff());
    balance.largest = std::max(balance.largest, loads.cwiseAbs().maxCoeff());
  }
  return balance;
}

RC_GTEST_PROP(FaceMoments, balance_every_tetrahedron, (Random random)) {
  const LoadedSolid body = random_loaded_solid(irregular_solid(random), random);
  const FaceMoments moments = equilibrated_moments(
      body.topology, body.computed_stress(), body.body_loads, body.boundary());
  const SolidBalance balance = balance_of(body, moments);
  RC_ASSERT(balance.left < 1e-11 * balance.largest);
}

RC_GTEST_PROP(FaceMoments, balance_the_stress_at_every_vertex,
              (Random random)) {
  const LoadedSolid body = random_loaded_solid(irregular_solid(random), random);
  const CellStresses<3> stress = body.computed_stress();
  const auto& [mesh, faces, edges, stars] = body.topology;
  const FaceMoments moments = equilibrated_moments(
      body.topology, stress, body.body_loads, body.boundary());
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Matrix3Xd Q = star_loads(body.topology, v, stress, body.body_loads);
    for (int k = 0; k < stars.count(v); ++k) {
      const int t = stars.cell[stars.start[v] + k],
                local = stars.local[stars.start[v] + k];
      Vector3d sum = -Q.col(k);
      for (int face = 0; face < 4; ++face)
        if (face != local)
          sum += loads_of(mesh, faces, moments, t)
                     .col(3 * face + place_on_facet<3>(face, local));
      RC_ASSERT(sum.norm() < 1e-11 * moments.cwiseAbs().maxCoeff());
    }
  }
}

RC_GTEST_PROP(FaceMoments, keep_known_boundary_tractions, (Random random)) {
  const LoadedSolid body = random_loaded_solid(irregular_solid(random), random);
  const FaceTractions boundary = body.boundary();
  const FaceMoments moments = equilibrated_moments(
      body.topology, body.computed_stress(), body.body_loads, boundary);
  int known = 0;
  for (int f = 0; f < body.topology.facets.count(); ++f)
    for (int row = 0; row < 9; ++row)
      if (boundary.known(row % 3, f)) {
        ++known;
        RC_ASSERT(moments(row, f) == boundary.moments(row, f));
      }
  RC_ASSERT(known > 0);
}

RC_GTEST_PROP(FaceMoments, are_those_of_a_constant_stress, (Random random)) {
  // u linear: its tractions are the mean stresses already
  LoadedSolid body(irregular_solid(random));
  const Matrix3d gradient = random_matrix(3, 3, random);
  for (int side : {low_x, high_x, low_y, high_y, low_z, high_z})
    body.move(side, [&](const Vector3d& x) { return gradient * x; });
  const CellStresses<3> stress = body.computed_stress();
  const auto& [mesh, faces, edges, stars] = body.topology;
  const FaceMoments moments = equilibrated_moments(
      body.topology, stress, body.body_loads, body.boundary());
  for (int f = 0; f < faces.count(); ++f) {
    const VoigtVector<3> sigma = stress.col(0);
    const Vector3d third = facet_measure(mesh, faces, f) / 3 *
                           traction(sigma, facet_normal(mesh, faces, f));
    RC_ASSERT((moments.col(f) - third.replicate<3, 1>()).norm() < 1e-11);
  }
}

RC_GTEST_PROP(FaceMoments, are_nearest_to_the_mean_stresses, (Random random)) {
  // around an inner vertex: opposite changes that balance raise the distance
  const LoadedSolid body = random_loaded_solid(irregular_solid(random), random);
  const CellStresses<3> stress = body.computed_stress();
  const auto& [mesh, faces, edges, stars] = body.topology;
  const FaceMoments moments = equilibrated_moments(
      body.topology, stress, body.body_loads, body.boundary());
  for (int e = 0; e < edges.count(); ++e) {
    if (edges.on_boundary[e]) continue;
    // equal forces through all faces around an edge keep the balance
    const int v = edges.vertices(0, e), end = edges.vertices(1, e);
    const Vector3d along = mesh.vertices.col(end) - mesh.vertices.col(v);
    Vector3d slope = Vector3d::Zero(), size = slope;
    for (int k = edges.facet_start[e]; k < edges.facet_start[e + 1]; ++k) {
      const int f = edges.facet[k];
      const Vector3d n = facet_normal(mesh, faces, f);
      const double area = facet_measure(mesh, faces, f);
      int third = faces.vertices.col(f).sum() - v - end;
      const Vector3d arm = mesh.vertices.col(third) - mesh.vertices.col(v);
      const double sign = n.dot(along.cross(arm)) > 0 ? 1 : -1;
      const VoigtVector<3> mean =
          0.5 * (stress.col(faces.cells(0, f)) + stress.col(faces.cells(1, f)));
      const Vector3d z0 = area / 3 * traction(mean, n),
                     z = moments.col(f).segment<3>(3 * faces.place_of(v, f));
      slope += sign * (z - z0) / area;
      size += (z - z0).cwiseAbs() / area;
    }
    RC_ASSERT(slope.norm() < 1e-9 * size.norm());
  }
}

}  // namespace
}  // namespace ffcontact
