// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/surface_error.hpp"

#include <algorithm>
#include <map>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/over.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/equilibrium/cone/facet_cone.hpp"
#include "ffcontact/estimate/bodies/clearing.hpp"
#include "ffcontact/estimate/error/face_fields.hpp"
#include "ffcontact/estimate/error/facing_error.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"

namespace ffcontact {

namespace {

/// The smallest change of a vertex that lowers its nodes out of the foundation, or 0.
Vector3d lowering(const ContactSurface& surface, const VectorXd& penetration,
                  int vertex, const std::vector<int>& nodes,
                  const Flags& prescribed, double largest) {
  return clearing(vertex, -surface.normal(Eigen::all, nodes),
                  penetration(nodes), prescribed, largest);
}

}  // namespace

VectorXd contact_error(const std::vector<ContactFacet<3>>& contact,
                       const SurfaceTractions& tractions) {
  return VectorXd::NullaryExpr(tractions.cols(), [&](Index m) {
    return 2 * contact_term<3>(contact[m], of_face(tractions, m));
  });
}

double cone_violation(const std::vector<ContactFacet<3>>& contact,
                      const SurfaceTractions& tractions) {
  return largest_over(tractions.cols(), [&](int m) {
    return cone_violation<3>(contact[m], of_face(tractions, m));
  });
}

VectorXd admissible_displacement(const Facets<3>& faces,
                                 const ContactSurface& surface,
                                 const SurfaceLaw& law,
                                 const Ref<const VectorXd>& displacement,
                                 const Flags& prescribed) {
  if (surface.against_a_body())
    return facing_admissible_displacement(faces, surface, law, displacement,
                                          prescribed);
  const VectorXd penetration =
      displacement_against_foundation(surface, law, displacement).row(0);
  const double largest = largest_clearing(law, displacement);
  std::map<int, std::vector<int>> nodes_of_vertex;
  for (int i = 0; i < surface.node_count(); ++i)
    nodes_of_vertex[surface.vertex[i]].push_back(i);
  VectorXd u = displacement;
  for (const auto& [vertex, nodes] : nodes_of_vertex)
    u.segment<3>(dof_of<3>(vertex, 0)) +=
        lowering(surface, penetration, vertex, nodes, prescribed, largest);
  return u;
}

DeepestNode deepest_node(const Facets<3>& faces, const ContactSurface& surface,
                         const SurfaceLaw& law,
                         const Ref<const VectorXd>& displacement) {
  if (surface.against_a_body())
    return deepest_facing_node(faces, surface, law, displacement);
  DeepestNode deepest;
  const double value =
      displacement_against_foundation(surface, law, displacement)
          .row(0)
          .maxCoeff(&deepest.node);
  deepest.depth = std::max(0.0, value);
  return deepest;
}

BetweenNodes between_nodes(const Facets<3>& faces,
                           const ContactSurface& surface, const SurfaceLaw& law,
                           const SurfaceTractions& tractions,
                           const Ref<const VectorXd>& displacement) {
  if (surface.against_a_body())
    return facing_between_nodes(faces, surface, law, tractions, displacement);
  const std::vector<FrictionCone> cones = law_cones(law, surface);
  const Matrix3Xd w =
      displacement_against_foundation(surface, law, displacement);
  BetweenNodes found;
  for (int m = 0; m < surface.face_count(); ++m) {
    if (surface.face_node.col(m).minCoeff() < 0) continue;
    FaceFields fields = fields_on_face(surface, cones, m, tractions.col(m));
    fields.motion = Matrix3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const int node = surface.face_node(k, m);
      fields.motion.col(k) = surface.frame(node) * w.col(node);
    }
    note(fields, fields.normal, m, found);
  }
  return found;
}

}  // namespace ffcontact
