// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/airy_energy.hpp"

#include <gtest/gtest.h>

#include "support/balances.hpp"
#include "support/meshes.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(AiryEnergy, expands_the_energy_of_the_composite_stress,
              (Random random)) {
  const Topology body = topology_of(irregular(3, 3, 3, 3, random));
  const AirySpace space(body.mesh, body.edges);
  const VectorXd airy = random_vector(space.unknowns(), random);
  EdgeLoadsOfAll change = EdgeLoadsOfAll::Zero(12, body.mesh.cell_count());
  add_airy_loads(space, airy, change);
  for (int t = 0; t < body.mesh.cell_count(); ++t) {
    const TriangleCorners corners = corners_of(body.mesh, t);
    const Matrix3d compliance = random_law(random);
    const Loads loads = balanced_loads(corners, random);
    const auto energy_of = [&](const EdgeLoads& on_edges) {
      return energy(corners, compliance,
                    composite_stress(corners, on_edges, loads.in_body));
    };
    const double before = energy_of(loads.on_edges),
                 after = energy_of(loads.on_edges + change.col(t));
    const AiryEnergy form =
        airy_energy(space, t, compliance, loads.on_edges, loads.in_body);
    const LocalAiry x = local_airy(space, airy, t);
    const double expanded = dot(x, form.times(x)) + 2 * dot(x, form.slope);
    RC_ASSERT(std::abs(after - before - expanded) < 1e-10 * (after + before));
  }
}

RC_GTEST_PROP(AiryEnergy, is_blind_to_linear_functions, (Random random)) {
  const Topology body = topology_of(irregular(3, 3, 3, 3, random));
  const AirySpace space(body.mesh, body.edges);
  const Vector3d linear = random_vector(3, random);
  VectorXd airy(space.unknowns());
  for (int v = 0; v < body.mesh.vertex_count(); ++v)
    airy.segment<3>(space.of_vertex(v))
        << (linear[0] + linear.tail<2>().dot(body.mesh.vertices.col(v))) /
               space.length[v],
        linear[1], linear[2];
  for (int e = 0; e < body.edges.count(); ++e)
    airy[space.of_edge(e)] =
        linear.tail<2>().dot(edge_normal(body.mesh, body.edges, e));
  for (int t = 0; t < body.mesh.cell_count(); ++t) {
    const Loads loads = balanced_loads(corners_of(body.mesh, t), random);
    const AiryEnergy form = airy_energy(space, t, random_law(random),
                                        loads.on_edges, loads.in_body);
    const LocalAiry x = local_airy(space, airy, t), K_x = form.times(x);
    const double size = form.own[0].norm() + form.edge_own.norm();
    RC_ASSERT(std::sqrt(dot(K_x, K_x)) < 1e-10 * size * std::sqrt(dot(x, x)));
    RC_ASSERT(std::abs(dot(x, form.slope)) <
              1e-10 * std::sqrt(dot(x, x) * dot(form.slope, form.slope)));
  }
}

}  // namespace
}  // namespace ffcontact
