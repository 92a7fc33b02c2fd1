// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// Distances of facing polygons between the smooth surfaces in place of the flat faces of both
/// bodies: with the cubic triangles c through the vertices and normals of each face
/// (point_on_cubic_triangle), what they are beside the faces along the contact direction n is
/// added,
///     s + ((c_2 - x_2) - (c_1 - x_1)) . n.
/// Nothing changes where the normals of a face are the same.
/// @param surface   whole, that of the contact faces of the polygons
/// @param opposite  that of the opposite faces; those that are not on it stay flat
void smooth_distances(const SolidMesh& mesh, const Facets<3>& faces,
                      const ContactSurface& surface,
                      const ContactSurface& opposite,
                      std::vector<FacingPolygon>& polygons);

/// How far smooth surfaces are beside their faces, at most at the middles of faces and their
/// sides [mm].
double largest_sagitta(const SolidMesh& mesh, const Facets<3>& faces,
                       const ContactSurface& surface);

}  // namespace ffcontact
