// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "ffcontact/interface/contact_line.hpp"
#include "ffcontact/interface/contact_surface.hpp"

/// What lines and surfaces on which contact may occur have in common.
namespace ffcontact {

/// Where contact may occur: of plane bodies a line, of solids a surface.
template <int d>
using LineOrSurface = std::conditional_t<d == 2, ContactLine, ContactSurface>;

/// Mesh facets of the contact facets.
inline const VectorXi& facets_of(const ContactLine& line) { return line.edge; }
inline const VectorXi& facets_of(const ContactSurface& surface) {
  return surface.face;
}

/// Nodes of a contact facet.
inline Vector2i nodes_of(const ContactLine& line, int edge) {
  return line.edge_node.col(edge);
}
inline Vector3i nodes_of(const ContactSurface& surface, int face) {
  return surface.face_node.col(face);
}

/// Calls of_facet(mesh facet, contact facet) for the mesh facets of the contact facets, and
/// for those of other bodies that these face, which may come several times.
template <class OfFacet>
void for_touching_facets(const ContactLine& line, OfFacet&& of_facet) {
  for (int e = 0; e < line.edge_count(); ++e) of_facet(line.edge[e], e);
  for (const FacingPiece& piece : line.pieces)
    of_facet(piece.opposite_edge, piece.contact_edge);
}
template <class OfFacet>
void for_touching_facets(const ContactSurface& surface, OfFacet&& of_facet) {
  for (int m = 0; m < surface.face_count(); ++m) of_facet(surface.face[m], m);
  for (const FacingPolygon& polygon : surface.polygons)
    of_facet(polygon.opposite_face, polygon.contact_face);
}

}  // namespace ffcontact
