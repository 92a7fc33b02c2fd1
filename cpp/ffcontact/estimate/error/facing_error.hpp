// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/surface_law.hpp"
#include "ffcontact/estimate/error/between_nodes.hpp"
#include "ffcontact/estimate/error/contact_faces.hpp"
#include "ffcontact/estimate/error/deepest_node.hpp"

namespace ffcontact {

/// Of a surface against another body the jump
///     w = [u] = u(x) - u(y),   y on the opposite face that x faces,
/// is linear on each polygon of the common refinement of both surfaces, whatever their
/// meshes: what holds at the corners of the polygons holds everywhere. r_hat, c, gap and
/// the displacement of the load step before are linear between the nodes (FaceHats) on the
/// faces that carry the multipliers. At each place the law is that of the face's nodes
/// with their shares chi_a there, along the normal and the tangents of each: on a plane
/// these are the same.

/// contact_error of a surface against another body:
///     2 sum over a of int chi_a (c_a |w_t| + r_a . (w - previous - gap n)),
/// |w_t| linear on the triangles of each polygon.
VectorXd facing_contact_error(const SolidMesh& mesh, const Facets<3>& faces,
                              const ContactSurface& surface,
                              const SurfaceLaw& law,
                              const Ref<const Matrix3Xd>& traction,
                              const Ref<const VectorXd>& displacement);

/// u_hat: u_h with w_n <= gap at all corners. A corner that is delta too deep asks of each
/// own vertex of its face delta over the share of those that are free along n, and gets
/// the largest that any corner asks for, by the smallest change of the vertex's free
/// components; where own vertices are prescribed those of the opposite face give way.
VectorXd facing_admissible_displacement(const Facets<3>& faces,
                                        const ContactSurface& surface,
                                        const SurfaceLaw& law,
                                        const Ref<const VectorXd>& displacement,
                                        const Flags& prescribed);

/// Where w_n - gap is the largest: the node that has the largest share there.
DeepestNode deepest_facing_node(const Facets<3>& faces,
                                const ContactSurface& surface,
                                const SurfaceLaw& law,
                                const Ref<const VectorXd>& displacement);

/// On all polygons; facets are contact faces.
BetweenNodes facing_between_nodes(const Facets<3>& faces,
                                  const ContactSurface& surface,
                                  const SurfaceLaw& law,
                                  const SurfaceTractions& tractions,
                                  const Ref<const VectorXd>& displacement);

}  // namespace ffcontact
