// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/surface_error.hpp"

#include <algorithm>
#include <map>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/over.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/equilibrium/cone/facet_cone.hpp"
#include "ffcontact/estimate/bodies/clearing.hpp"
#include "ffcontact/estimate/bodies/contact_subset.hpp"
#include "ffcontact/estimate/error/facing_error.hpp"
#include "ffcontact/estimate/tractions/surface_tractions.hpp"

namespace ffcontact {

namespace {

/// Lowers the nodes of each vertex by their depths along their normals, where these are above
/// 0, by the smallest change.
void lower(const ContactSurface& surface, const ContactLaw<3>& law,
           const VectorXd& depths, const Flags& prescribed, VectorXd& u) {
  const double largest = largest_clearing(law, u);
  std::map<int, std::vector<int>> nodes_of_vertex;
  for (int i = 0; i < surface.node_count(); ++i)
    nodes_of_vertex[surface.vertex[i]].push_back(i);
  for (const auto& [vertex, nodes] : nodes_of_vertex)
    u.segment<3>(dof_of<3>(vertex, 0)) +=
        clearing(vertex, -surface.normal(Eigen::all, nodes), depths(nodes),
                 prescribed, largest);
}

/// The largest that the sides of faces that are not clear ask of each node [p].
VectorXd depths_between(const Facets<3>& faces, const ContactSurface& surface,
                        const ContactLaw<3>& law, const VectorXd& u,
                        bool alone) {
  VectorXd depths = VectorXd::Zero(surface.node_count());
  for (int m = 0; m < surface.face_count(); ++m) {
    const FaceMotion motion = motion_on_face(faces, surface, law, m, {}, u);
    if (deepest_on(motion, {0, 1, 2}) == 0) continue;
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const double depth = depth_between(motion, k, l, alone);
      for (const int corner : {k, l}) {
        double& asked = depths[surface.face_node(corner, m)];
        asked = std::max(asked, depth);
      }
    }
  }
  return depths;
}

}  // namespace

VectorXd contact_error(const std::vector<ContactFacet<3>>& contact,
                       const SurfaceTractions& tractions) {
  return VectorXd::NullaryExpr(tractions.cols(), [&](Index m) {
    return 2 * contact_term<3>(contact[m], of_face(tractions, m));
  });
}

VectorXd contact_error(const SolidMesh& mesh, const Facets<3>& faces,
                       const ContactSurface& surface, const ContactLaw<3>& law,
                       const std::vector<ContactFacet<3>>& contact,
                       const TractionFields& traction,
                       const Ref<const VectorXd>& displacement) {
  VectorXd part = surface.against_a_body()
                      ? facing_contact_error(mesh, faces, surface, law,
                                             traction, displacement)
                      : VectorXd::Zero(surface.face_count());
  const VectorXi given = surface_faces(contact);
  part(given) = contact_error(contact, traction.on_faces(Eigen::all, given));
  return part;
}

double cone_violation(const std::vector<ContactFacet<3>>& contact,
                      const SurfaceTractions& tractions) {
  return largest_over(tractions.cols(), [&](int m) {
    return cone_violation<3>(contact[m], of_face(tractions, m));
  });
}

VectorXd admissible_displacement(const Facets<3>& faces,
                                 const ContactSurface& surface,
                                 const ContactLaw<3>& law,
                                 const Ref<const VectorXd>& displacement,
                                 const Flags& prescribed) {
  if (surface.against_a_body())
    return facing_admissible_displacement(faces, surface, law, displacement,
                                          prescribed);
  VectorXd u = displacement;
  lower(surface, law,
        displacement_against_foundation(surface, law, displacement).row(0),
        prescribed, u);
  return u;
}

VectorXd cleared_between_nodes(const Facets<3>& faces,
                               const ContactSurface& surface,
                               const ContactLaw<3>& law,
                               const Ref<const VectorXd>& displacement,
                               const Flags& prescribed) {
  if (!turns(surface)) return displacement;
  if (surface.against_a_body())
    return facing_cleared_between(faces, surface, law, displacement,
                                  prescribed);
  constexpr int most_passes = 10;
  VectorXd u = displacement;
  for (int pass = 0; pass < most_passes; ++pass) {
    const VectorXd depths = depths_between(faces, surface, law, u, pass > 0);
    if (depths.isZero(0)) break;
    lower(surface, law, depths, prescribed, u);
  }
  return u;
}

DeepestNode deepest_node(const Facets<3>& faces, const ContactSurface& surface,
                         const ContactLaw<3>& law,
                         const Ref<const VectorXd>& displacement) {
  if (surface.against_a_body())
    return deepest_facing_node(faces, surface, law, displacement);
  DeepestNode deepest;
  for (int m = 0; m < surface.face_count(); ++m) {
    const FaceMotion motion =
        motion_on_face(faces, surface, law, m, {}, displacement);
    const double depth = deepest_on(motion, {0, 1, 2});
    if (depth > deepest.depth)
      deepest = {depth,
                 surface.face_node(deepest_corner(motion, {0, 1, 2}), m)};
  }
  return deepest;
}

BetweenNodes between_nodes(const Facets<3>& faces,
                           const ContactSurface& surface,
                           const ContactLaw<3>& law,
                           const TractionFields& tractions,
                           const Ref<const VectorXd>& displacement) {
  if (surface.against_a_body())
    return facing_between_nodes(faces, surface, law, tractions, displacement);
  const std::vector<FrictionCone> cones = law_cones(law);
  BetweenNodes found;
  for (int m = 0; m < surface.face_count(); ++m) {
    if (is_bonded<3>(surface, law, m)) continue;
    const FaceMotion motion =
        motion_on_face(faces, surface, law, m, {}, displacement);
    note(traction_on_face(surface, cones, m, tractions), motion, motion.normal,
         m, found);
  }
  return found;
}

}  // namespace ffcontact
