// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/face_moments.hpp"

#include <gtest/gtest.h>

#include "ffcontact/elastic/stiffness.hpp"
#include "support/loaded_solid.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/tetrahedra.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Largest force or moment over size that is left on a tetrahedron, and largest value.
struct SolidBalance {
  double left = 0, largest = 0;
};

SolidBalance balance_of(const LoadedSolid& body, const FaceMoments& moments) {
  const auto& [mesh, faces, edges, stars] = body.topology;
  SolidBalance balance;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const FaceLoads loads = loads_of(mesh, faces, moments, t);
    const SolidBodyLoads in_body = body.body_loads.col(t).reshaped(3, 4);
    const auto out = out_of_balance(corners_of(mesh, t), loads, in_body);
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
  const Matrix6Xd stress = body.computed_stress();
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
  for (int f = 0; f < body.topology.faces.count(); ++f)
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
  const Matrix6Xd stress = body.computed_stress();
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
  const Matrix6Xd stress = body.computed_stress();
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

RC_GTEST_PROP(SolidResidual, is_what_the_loads_lack, (Random random)) {
  const LoadedSolid body = random_loaded_solid(irregular_solid(random), random);
  const VectorXd u = displacement(body.system());
  const SolidResidual none = nodal_residual(body.topology, body.stress(u),
                                            body.body_loads, body.boundary());
  RC_ASSERT(none.missing.cwiseAbs().maxCoeff() < 1e-11 * none.scale);

  const VectorXd change = random_vector(u.size(), random);
  const SolidResidual less =
      less_stress(body.topology, none, body.stress(change));
  const RowMatrix K = stiffness(body.mesh(), body.hooke);
  const VectorXd forces = K * change;
  const SolidResidual again = with_forces(less, forces);
  RC_ASSERT(less.missing.cwiseAbs().maxCoeff() > 0.1);
  RC_ASSERT(again.missing.cwiseAbs().maxCoeff() < 1e-10);
}

TEST(FaceTractions, contact_is_linear_between_the_nodes) {
  const SolidMesh mesh = brick({1, 1, 1}, {1, 1, 1});
  const Facets<3> faces = facets_of(mesh);
  const ContactSurface surface = contact_surface(mesh, faces, {low_z});
  const FaceTractions none = given_tractions(
      mesh, faces, std::vector<char>(24, 0), FaceMoments::Zero(9, 12));
  Matrix3Xd r(3, 4);
  for (int i = 0; i < 4; ++i) {
    const Vector3d x = mesh.vertices.col(surface.vertex[i]);
    r.col(i) << -1 - x.x(), 2 * x.y(), 3;
  }
  const FaceTractions boundary = with_contact(none, mesh, faces, surface, r);
  // n = -z, t1 = x, t2 = y: int of (2 y, 3, 1 + x) and of its work on x
  Vector3d force = Vector3d::Zero();
  double work = 0;
  for (int f = 0; f < faces.count(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Vector3d moment = boundary.moments.col(f).segment<3>(3 * k);
      force += moment;
      work += mesh.vertices(0, faces.vertices(k, f)) * moment.z();
    }
  EXPECT_LT((force - Vector3d(1, 3, 1.5)).norm(), 1e-14);
  EXPECT_NEAR(work, 0.5 + 1.0 / 3, 1e-14);
}

TEST(FaceTractions, tractions_follow_the_order_of_the_face) {
  std::mt19937 random(1);
  const SolidMesh mesh = shuffled(brick({1, 1, 1}, {1, 1, 1}), random);
  const Facets<3> faces = facets_of(mesh);
  FaceMoments given = FaceMoments::Zero(9, 12);
  for (int f = 0; f < 12; ++f)
    for (int k = 0; k < 3; ++k)
      given.col(f).segment<3>(3 * k).setConstant(mesh.boundary(k, f));
  const FaceTractions boundary =
      given_tractions(mesh, faces, std::vector<char>(24, 0), given);
  for (int f = 0; f < faces.count(); ++f) {
    if (!faces.on_boundary(f)) continue;
    for (int row = 0; row < 9; ++row)
      EXPECT_EQ(boundary.moments(row, f), faces.vertices(row / 3, f));
  }
}

TEST(FaceTractions, refuses_values_that_are_not_finite) {
  const SolidMesh mesh = brick({1, 1, 1}, {1, 1, 1});
  FaceMoments given = FaceMoments::Zero(9, 12);
  given(3, 2) = std::nan("");
  EXPECT_TRUE(says(refusal([&] {
                     given_tractions(mesh, facets_of(mesh),
                                     std::vector<char>(24, 0), given);
                   }),
                   "traction[21]"));
}

}  // namespace
}  // namespace ffcontact
