// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_corrections.hpp"

#include <gtest/gtest.h>

#include "ffcontact/equilibrium/star_relaxation.hpp"
#include "support/balances.hpp"
#include "support/meshes.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Edge loads of triangle k of a star for given unknowns.
EdgeLoads loads_of(const StarCorrections& star, int k, const Eigen::VectorXd& unknowns) {
  Eigen::Matrix<double, 5, 1> mine;
  const std::array<int, 5> columns = star.columns(k);
  for (int a = 0; a < 5; ++a) mine[a] = unknowns[columns[a]];
  const Eigen::Matrix<double, 8, 1> loads = star.triangle_loads(k) * mine;
  EdgeLoads result = EdgeLoads::Zero();
  const std::array<int, 8> rows = star.rows(k);
  for (int r = 0; r < 8; ++r) result[rows[r]] = loads[r];
  return result;
}

RC_GTEST_PROP(StarCorrections, keep_every_triangle_in_equilibrium, (Random random)) {
  const Starred body(irregular(3, 3, 3, 3, random));
  for (int v = 0; v < body.mesh.vertex_count(); ++v) {
    const StarCorrections star(body.mesh, body.edges, body.stars, v);
    const Eigen::VectorXd unknowns = random_vector(star.unknowns(), random);
    for (int k = 0; k < star.triangle_count(); ++k) {
      const EdgeLoads loads = loads_of(star, k, unknowns);
      RC_ASSERT(out_of_balance(corners_of(body.mesh, star.triangle(k)), loads, BodyLoads::Zero()).norm() < 1e-11);
    }
  }
}

RC_GTEST_PROP(StarCorrections, load_the_two_triangles_beside_a_spoke_oppositely, (Random random)) {
  const Starred body(irregular(3, 3, 3, 3, random));
  for (int v = 0; v < body.mesh.vertex_count(); ++v) {
    const StarCorrections star(body.mesh, body.edges, body.stars, v);
    const Eigen::VectorXd unknowns = random_vector(star.unknowns(), random);
    Eigen::Matrix4Xd sum =
        Eigen::Matrix4Xd::Zero(4, body.edges.count());  // at the first and second vertex of every edge
    for (int k = 0; k < star.triangle_count(); ++k) {
      const EdgeLoads loads = loads_of(star, k, unknowns);
      const int t = star.triangle(k);
      for (int local = 0; local < 3; ++local) {
        const bool left = body.edges.eta(local, t) > 0;
        sum.block<2, 1>(left ? 0 : 2, body.edges.of_triangle(local, t)) += loads.segment<2>(4 * local);
        sum.block<2, 1>(left ? 2 : 0, body.edges.of_triangle(local, t)) += loads.segment<2>(4 * local + 2);
      }
    }
    for (int e = 0; e < body.edges.count(); ++e) RC_ASSERT((body.edges.on_boundary(e) || sum.col(e).norm() < 1e-13));
  }
}

RC_GTEST_PROP(StarCorrections, are_all_that_equilibrium_leaves_at_an_inner_vertex, (Random random)) {
  const Starred body(irregular(3, 3, 3, 3, random));
  for (int v = 0; v < body.mesh.vertex_count(); ++v) {
    if (body.stars.on_boundary(v)) continue;
    const StarCorrections star(body.mesh, body.edges, body.stars, v);
    const int m = star.triangle_count();
    // 4 m end values with 3 m - 3 independent conditions leave m + 3.
    RC_ASSERT(star.unknowns() == m + 3);
    Eigen::MatrixXd map(12 * m, star.unknowns());
    for (int k = 0; k < m; ++k)
      for (int j = 0; j < star.unknowns(); ++j)
        map.block<12, 1>(12 * k, j) = loads_of(star, k, Eigen::VectorXd::Unit(star.unknowns(), j));
    RC_ASSERT(Eigen::FullPivLU<Eigen::MatrixXd>(map).rank() == m + 3);
  }
}

}  // namespace
}  // namespace ffcontact
