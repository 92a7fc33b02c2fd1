// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/estimate/displacement/rough_contact.hpp"
#include "ffcontact/estimate/displacement/sticking_displacement.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// The largest of C [MPa].
double stiffest(const HookeTensors<3>& hooke) {
  double largest = 0;
  for (const auto& C : hooke) largest = std::max(largest, max_norm(C));
  return largest;
}

/// The slip below which sticking is cheaper, 0 where friction is not rough [mm]: the most of
/// a node's faces.
VectorXd worth_on_surface(const ContactSurface& surface,
                          const std::vector<FrictionCone>& cones,
                          const Matrix3Xd& traction, double stiffness) {
  VectorXd worth = VectorXd::Zero(surface.node_count());
  for (const auto& nodes : surface.face_node.colwise()) {
    if (nodes.minCoeff() < 0 || cones[nodes[0]].bonded) continue;
    double bound = 0, normal = 0, largest = 0;
    for (const int i : nodes) {
      bound += cones[i].bound(traction(0, i)) / 3;
      normal += std::abs(traction(0, i)) / 3;
      largest = std::max(largest, traction.col(i).norm());
    }
    if (!is_rough(bound, normal)) continue;
    for (const int i : nodes)
      worth[i] = std::max(
          worth[i], slip_worth_sticking(bound, largest,
                                        std::sqrt(surface.area[i]), stiffness));
  }
  return worth;
}

/// Does each node face at most one vertex, and has its own to itself?
Flags movable_nodes(const ContactSurface& surface, Index vertices) {
  VectorXi count = VectorXi::Zero(vertices);
  for (const int v : surface.vertex) ++count[v];
  Flags movable(surface.node_count(), 0);
  for (int i = 0; i < surface.node_count(); ++i) {
    bool faces_one = true;
    visit_opposite(surface, i, [&](int, double weight) {
      faces_one = faces_one && std::abs(weight - 1) < 1e-9;
    });
    movable[i] = faces_one && count[surface.vertex[i]] == 1;
  }
  return movable;
}

/// Takes the slip from a vertex, unless a support holds what has to move.
void take_slip(int vertex, Vector3d slip, const Flags& prescribed,
               VectorXd& u) {
  const double size = max_norm(slip);
  for (int c = 0; c < 3; ++c) {
    if (!prescribed[dof_of<3>(vertex, c)]) continue;
    if (std::abs(slip[c]) > no_component * size) return;
    slip[c] = 0;
  }
  u.segment<3>(dof_of<3>(vertex, 0)) -= slip;
}

}  // namespace

VectorXd sticking_displacement(const SolvedProblem<3>& solved,
                               VectorXd displacement) {
  const auto& [topology, surface, system, body] = solved;
  const std::vector<FrictionCone> cones = law_cones(body.law);
  const Matrix3Xd traction =
      lumped_tractions(body.law, surface, body.multipliers);
  const VectorXd worth =
      worth_on_surface(surface, cones, traction, stiffest(body.hooke));
  if (worth.isZero(0)) return displacement;
  const double largest = max_norm(traction);
  const Flags movable = movable_nodes(surface, topology.mesh.vertex_count());
  const Matrix3Xd w =
      displacement_against_foundation(surface, body.law, displacement);
  for (int i = 0; i < surface.node_count(); ++i) {
    const Vector2d slip = w.col(i).tail<2>();
    if (!movable[i] || slip.norm() >= worth[i] ||
        slips(cones[i].bound(traction(0, i)), traction.col(i).tail<2>().norm(),
              largest))
      continue;
    take_slip(surface.vertex[i], surface.frame(i).rightCols<2>() * slip,
              system.prescribed, displacement);
  }
  return displacement;
}

}  // namespace ffcontact
