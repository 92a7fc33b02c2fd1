// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_corrections.hpp"

#include <gtest/gtest.h>

#include <set>

#include "ffcontact/equilibrium/star_energy.hpp"
#include "support/balances.hpp"
#include "support/meshes.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Edge loads of all triangles for given unknowns of a star.
EdgeLoadsOfAll loads_of(const AirySpace& space, const Stars& stars, int vertex,
                        const VectorXd& unknowns) {
  VectorXd airy = VectorXd::Zero(space.unknowns());
  add_corrections(space, stars, vertex, unknowns, airy);
  EdgeLoadsOfAll loads = EdgeLoadsOfAll::Zero(12, space.mesh.cell_count());
  add_airy_loads(space, airy, loads);
  return loads;
}

RC_GTEST_PROP(StarCorrections, keep_every_triangle_in_equilibrium,
              (Random random)) {
  const Topology body = topology_of(irregular(3, 3, 3, 3, random));
  const AirySpace space(body.mesh, body.edges);
  for (int v = 0; v < body.mesh.vertex_count(); ++v) {
    const VectorXd unknowns =
        random_vector(star_unknowns(body.stars, v), random);
    const EdgeLoadsOfAll loads = loads_of(space, body.stars, v, unknowns);
    for (int t = 0; t < body.mesh.cell_count(); ++t)
      RC_ASSERT(out_of_balance(corners_of(body.mesh, t), loads.col(t),
                               BodyLoads::Zero())
                    .norm() < 1e-11);
  }
}

RC_GTEST_PROP(StarCorrections, load_the_two_triangles_beside_a_spoke_oppositely,
              (Random random)) {
  const Topology body = topology_of(irregular(3, 3, 3, 3, random));
  const AirySpace space(body.mesh, body.edges);
  for (int v = 0; v < body.mesh.vertex_count(); ++v) {
    const VectorXd unknowns =
        random_vector(star_unknowns(body.stars, v), random);
    const EdgeLoadsOfAll all = loads_of(space, body.stars, v, unknowns);
    Matrix4Xd sum =
        // at the first and second vertex of every edge
        Matrix4Xd::Zero(4, body.edges.count());
    for (int t = 0; t < body.mesh.cell_count(); ++t) {
      const EdgeLoads loads = all.col(t);
      for (int local = 0; local < 3; ++local) {
        const bool left = body.edges.eta(local, t) > 0;
        sum.block<2, 1>(left ? 0 : 2, body.edges.of_cell(local, t)) +=
            loads.segment<2>(4 * local);
        sum.block<2, 1>(left ? 2 : 0, body.edges.of_cell(local, t)) +=
            loads.segment<2>(4 * local + 2);
      }
    }
    for (int e = 0; e < body.edges.count(); ++e)
      RC_ASSERT((body.edges.on_boundary(e) || sum.col(e).norm() < 1e-13));
  }
}

RC_GTEST_PROP(StarCorrections,
              are_all_that_equilibrium_leaves_at_an_inner_vertex,
              (Random random)) {
  const Topology body = topology_of(irregular(3, 3, 3, 3, random));
  const AirySpace space(body.mesh, body.edges);
  for (int v = 0; v < body.mesh.vertex_count(); ++v) {
    if (body.stars.on_boundary(v)) continue;
    const int m = body.stars.triangle_count(v),
              n = star_unknowns(body.stars, v);
    // 4 m end values with 3 m - 3 independent conditions leave m + 3.
    RC_ASSERT(n == m + 3);
    MatrixXd map(12 * body.mesh.cell_count(), n);
    for (int j = 0; j < n; ++j)
      map.col(j) =
          loads_of(space, body.stars, v, VectorXd::Unit(n, j)).reshaped();
    RC_ASSERT(Eigen::FullPivLU<MatrixXd>(map).rank() == m + 3);
    std::set<int> star(
        body.stars.triangle.begin() + body.stars.triangle_start[v],
        body.stars.triangle.begin() + body.stars.triangle_start[v + 1]);
    for (int t = 0; t < body.mesh.cell_count(); ++t)
      RC_ASSERT((map.middleRows<12>(12 * t).norm() > 0) == (star.count(t) > 0));
  }
}

RC_GTEST_PROP(StarCorrections, have_the_moments_of_their_spokes,
              (Random random)) {
  const Topology body = topology_of(irregular(3, 3, 3, 3, random));
  const AirySpace space(body.mesh, body.edges);
  for (int v = 0; v < body.mesh.vertex_count(); ++v) {
    const StarCorrections star(space, body.stars, v);
    const VectorXd unknowns = random_vector(star.unknowns(), random);
    VectorXd airy = VectorXd::Zero(space.unknowns());
    add_corrections(space, body.stars, v, unknowns, airy);
    for (int k = 0; k < star.spoke_count(); ++k) {
      Vector4d mine;
      const std::array<int, 4> columns = star.columns_of_spoke(k);
      for (int a = 0; a < 4; ++a) mine[a] = unknowns[columns[a]];
      const Vector4d b = airy_moments(space, airy, star.spoke(k));
      const bool along = body.edges.vertices(0, star.spoke(k)) == v;
      const Vector4d seen = along ? b : -Vector4d(b[2], b[3], b[0], b[1]);
      RC_ASSERT((star.moments(k) * mine - seen).norm() < 1e-13);
    }
  }
}

}  // namespace
}  // namespace ffcontact
