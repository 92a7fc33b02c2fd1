// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// A polygon of the common refinement of two facing surfaces: the part of a contact face
/// that faces a part of one face of the opposite body along the contact direction. Places
/// on faces are barycentric coordinates; those on the two faces and the distance
/// correspond linearly.
struct FacingPolygon {
  int contact_face;    ///< number on the contact surface
  int opposite_face;   ///< facet of the mesh
  double area;         ///< of the part of the contact face [mm^2]
  Matrix3Xd own;       ///< corners on the contact face [3 x k]
  Matrix3Xd opposite;  ///< corners on the opposite face [3 x k]
  VectorXd
      distance;  ///< from the first to the second, along the direction [mm, k]
};

/// Pairs a contact surface with the faces of a body that it faces: along the mean n of
/// the contact directions at the nodes of a contact face, x faces y = x + s n, s > 0 where
/// they are apart. Of several faces that a point faces the nearest is paired; triangles
/// are clipped in the plane across n. The surfaces need not lie on each other, their
/// vertices need not match, and either may go on where the other ends.
/// @param opposite_labels  boundary labels of the opposite body
/// @return contact face by contact face, ascending
/// @throws std::invalid_argument  if nothing faces anything, or a vertex is on both
///                                surfaces
std::vector<FacingPolygon> facing_polygons(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const std::vector<int>& opposite_labels);

}  // namespace ffcontact
