// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/flags.hpp"
#include "ffcontact/estimate/error/between_nodes.hpp"
#include "ffcontact/estimate/error/contact_faces.hpp"
#include "ffcontact/estimate/error/deepest_node.hpp"
#include "ffcontact/estimate/error/face_fields.hpp"

namespace ffcontact {

/// Of a solid on a rigid foundation, and of faces that match; against another body
/// otherwise these are those of facing_error.hpp.

/// The contact part of e^2 on each of given contact faces [N mm]:
///     2 int (c |n x w| - m . (n x w) + r_n (w . n - gap)),   c = mu |r_n|, Tresca's bound, or the shear limit if that is less   [CHH01, (2.11), (2.19)]
/// for r = r_n n + n x m (BentTraction) and the cones of paid_cone. c is linear between the
/// nodes, and |n x w| its Bernstein polynomial (FaceCosts), which is a bound, without
/// quadrature. In the cone and without penetration no value is negative.
VectorXd contact_error(const std::vector<ContactFacet<3>>& contact,
                       const SurfaceTractions& tractions);

/// The same on all faces of a surface: on the given ones, and by facing_contact_error on
/// others that face another body [N mm].
/// @param displacement  with which the given faces move
VectorXd contact_error(const SolidMesh& mesh, const Facets<3>& faces,
                       const ContactSurface& surface, const ContactLaw<3>& law,
                       const std::vector<ContactFacet<3>>& contact,
                       const TractionFields& traction,
                       const Ref<const VectorXd>& displacement);

/// Largest of r_n and |r_t| less its bound on any face [MPa]; 0 in the cone.
double cone_violation(const std::vector<ContactFacet<3>>& contact,
                      const SurfaceTractions& tractions);

/// u_hat: u_h with u_n - gap lowered to min(u_n - gap, 0) at the nodes by the smallest
/// change of each vertex's free components; a vertex that no such change clears, or only
/// one of 1000 times the largest displacement or gap, stays as it is.
/// @param prescribed  1 where the dof is prescribed and stays
VectorXd admissible_displacement(const Facets<3>& faces,
                                 const ContactSurface& surface,
                                 const ContactLaw<3>& law,
                                 const Ref<const VectorXd>& displacement,
                                 const Flags& prescribed);

/// u_hat that keeps clear between the nodes, too, where normals turn on a face
/// (depth_between).
VectorXd cleared_between_nodes(const Facets<3>& faces,
                               const ContactSurface& surface,
                               const ContactLaw<3>& law,
                               const Ref<const VectorXd>& displacement,
                               const Flags& prescribed);

DeepestNode deepest_node(const Facets<3>& faces, const ContactSurface& surface,
                         const ContactLaw<3>& law,
                         const Ref<const VectorXd>& displacement);

/// Facets are contact faces.
BetweenNodes between_nodes(const Facets<3>& faces,
                           const ContactSurface& surface,
                           const ContactLaw<3>& law,
                           const TractionFields& tractions,
                           const Ref<const VectorXd>& displacement);

}  // namespace ffcontact
