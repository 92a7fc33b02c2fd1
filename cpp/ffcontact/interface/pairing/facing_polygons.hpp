// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// Pairs a contact surface with the faces of a body that it faces: along the mean n of
/// the contact directions at the nodes of a contact face, x faces y = x + s n, s > 0 where
/// they are apart. Of several faces that which x is inside of, or touches, comes first,
/// then the nearest in front; LineOfSight says which are faced at all, decided at one place
/// of what two triangles share, so that no body faces anything through itself. Triangles
/// are clipped in the plane across n. The surfaces need not lie on each other, their
/// vertices need not match, and either may go on where the other ends.
/// @param opposite_labels  boundary labels of the opposite body
/// @return contact face by contact face, ascending
/// @throws std::invalid_argument  if nothing faces anything
std::vector<FacingPolygon> facing_polygons(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const std::vector<int>& opposite_labels);

/// The first face of the surface, by its number in the mesh, that touches the front of a
/// face with one of the labels; -1 where none does.
int touching_face(const SolidMesh& mesh, const Facets<3>& faces,
                  const ContactSurface& surface,
                  const std::vector<int>& opposite_labels);

}  // namespace ffcontact
