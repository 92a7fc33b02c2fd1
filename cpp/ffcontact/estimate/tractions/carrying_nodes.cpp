// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/carrying_nodes.hpp"

#include <cmath>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/estimate/tractions/cone_projection.hpp"
#include "ffcontact/estimate/tractions/loaded_nodes.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Costs of openings above this much of what tractions gain are far larger.
constexpr double far_open = 3;

/// o of each node of a face whose vertices open by so much.
Vector3d mean_openings(const Vector3d& opening) {
  return (opening.array() + opening.sum()) / 4;
}

/// How far each node is open [mm].
VectorXd openings(const ContactSurface& surface, const ContactLaw<3>& law,
                  const Ref<const VectorXd>& u_hat) {
  return -displacement_against_foundation<3>(surface, law, u_hat)
              .row(0)
              .cwiseMin(0);
}

/// How far a node of a contact face moves for a traction of 1 MPa [mm/MPa].
double give(const MatchedBodies<3>& bodies, int face, int node) {
  const ContactSurface& surface = bodies.contact();
  const int cell = bodies.topology().facets.cells(0, surface.face[face]);
  return std::sqrt(surface.area[node]) / max_norm(bodies.body().hooke[cell]) +
         bodies.body().law.layer.normal;
}

/// Has a node a face that opens too far for tractions there? Bonded nodes have none.
Flags open_far(const MatchedBodies<3>& bodies, const Ref<const VectorXd>& u_hat,
               double largest) {
  const ContactSurface& surface = bodies.contact();
  const ContactLaw<3>& law = bodies.body().law;
  const VectorXd opening = openings(surface, law, u_hat);
  Flags far(surface.node_count(), 0);
  for (int m = 0; m < surface.face_count(); ++m) {
    const Vector3i nodes = surface.face_node.col(m);
    const Vector3d o = mean_openings(
        nodes.unaryExpr([&](int i) { return i < 0 ? 0 : opening[i]; }));
    for (int k = 0; k < 3; ++k)
      if (const int i = nodes[k]; i >= 0 && !law.is_bonded(i))
        far[i] |= o[k] > far_open * largest * give(bodies, m, i);
  }
  return far;
}

/// What of the tractions asks for contact: not Tresca's friction.
Matrix3Xd of_contact(const std::vector<FrictionCone>& cones,
                     Matrix3Xd traction) {
  for (Index i = 0; i < traction.cols(); ++i)
    if (cones[i].cohesion > 0) traction.col(i).tail<2>().setZero();
  return traction;
}

/// What nodes hand to each other.
struct Handing {
  const ContactSurface& surface;
  const Flags& far;
  const Flags& loaded;

  bool gives(int i) const { return i >= 0 && far[i] && loaded[i]; }
  bool takes(int i) const { return i >= 0 && !far[i] && loaded[i]; }

  /// Calls visit(from, to) for the nodes of each face of which one gives and one takes.
  template <class Visit>
  void visit_pairs(Visit&& visit) const {
    for (const auto& nodes : surface.face_node.colwise())
      for (const int from : nodes)
        for (const int to : nodes)
          if (gives(from) && takes(to)) visit(from, to);
  }

  /// Of each node.
  VectorXd takers() const {
    VectorXd count = VectorXd::Zero(surface.node_count());
    visit_pairs([&](int from, int) { ++count[from]; });
    return count;
  }

  /// Forces handed over, as tractions of who takes them.
  Matrix3Xd handed(const Ref<const Matrix3Xd>& traction,
                   const VectorXd& takers) const {
    Matrix3Xd more = Matrix3Xd::Zero(3, traction.cols());
    visit_pairs([&](int from, int to) {
      more.col(to) += surface.area[from] / surface.area[to] / takers[from] *
                      traction.col(from);
    });
    return more;
  }
};

}  // namespace

CarryingNodes carrying_nodes(const MatchedBodies<3>& bodies,
                             const Ref<const VectorXd>& u_hat,
                             const Ref<const Matrix3Xd>& traction) {
  const std::vector<FrictionCone> cones = traction_cones(bodies.body().law);
  const Matrix3Xd pressing = of_contact(cones, traction);
  const double largest = max_norm(traction);
  const Flags far = open_far(bodies, u_hat, largest),
              loaded = loaded_nodes(pressing);
  const Handing handing{bodies.contact(), far, loaded};
  const VectorXd takers = handing.takers();
  CarryingNodes result{traction + handing.handed(pressing, takers),
                       Flags(far.size(), 1)};
  for (Index i = 0; i < traction.cols(); ++i) {
    auto r = result.traction.col(i);
    result.carries[i] = !far[i] || (loaded[i] && takers[i] == 0);
    if (result.carries[i])
      r = cone_projection(cones[i], r).point;
    else
      r -= pressing.col(i);
  }
  return result;
}

}  // namespace ffcontact
