// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/estimate/error/deepest_node.hpp"
#include "ffcontact/estimate/error/face_fields.hpp"

namespace ffcontact {

/// Of a surface against another body the jump
///     w = [u] = u(x) - u(y),   y on the opposite face that x faces,
/// is linear on each polygon of the common refinement of both surfaces, whatever their
/// meshes (FaceMotion). r_hat (BentTraction), c, gap and the displacement of the load step
/// before are linear between the nodes (FaceHats) on the faces that carry the multipliers.

/// contact_error of a surface against another body, by the triangles of each polygon.
VectorXd facing_contact_error(const SolidMesh& mesh, const Facets<3>& faces,
                              const ContactSurface& surface,
                              const ContactLaw<3>& law,
                              const TractionFields& traction,
                              const Ref<const VectorXd>& displacement);

/// u_hat: u_h with w . n <= gap at all corners. A corner that is delta too deep asks of each
/// own vertex of its face delta over the share of those that are free along n, and gets
/// the largest that any corner asks for, by the smallest change of the vertex's free
/// components; where own vertices are prescribed those of the opposite face give way.
VectorXd facing_admissible_displacement(const Facets<3>& faces,
                                        const ContactSurface& surface,
                                        const ContactLaw<3>& law,
                                        const Ref<const VectorXd>& displacement,
                                        const Flags& prescribed);

/// The same between the corners (depth_between).
VectorXd facing_cleared_between(const Facets<3>& faces,
                                const ContactSurface& surface,
                                const ContactLaw<3>& law,
                                const Ref<const VectorXd>& displacement,
                                const Flags& prescribed);

/// Where w . n - gap is the largest: the node that has the largest share there.
DeepestNode deepest_facing_node(const Facets<3>& faces,
                                const ContactSurface& surface,
                                const ContactLaw<3>& law,
                                const Ref<const VectorXd>& displacement);

/// On all polygons; facets are contact faces.
BetweenNodes facing_between_nodes(const Facets<3>& faces,
                                  const ContactSurface& surface,
                                  const ContactLaw<3>& law,
                                  const TractionFields& traction,
                                  const Ref<const VectorXd>& displacement);

}  // namespace ffcontact
