// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// A node of a contact surface, and a contact face that has it.
struct NodeOfFace {
  int node, face;
};

/// The node of a curved surface that fits what it faces: its normals n turn, and those m
/// of the opposite faces turn with them,
///     1/2 < (sum a . b) / (sum a . a) < 2,   a = n_j - n_k,  b = m_k - m_j
/// over the sides j, k of contact faces with |a| > 0.01: 1 for a pin in its bore, 0 on a
/// plane, negative for two balls. Nodal normals and gaps of the polyhedra are then off by
/// as much as the surfaces are apart.
/// @param polygons  of facing_polygons; none for a rigid foundation without a gap, which
///                  fits any surface
/// @return a node where normals turn the most; nothing where no surface is curved, or none
///         fits
std::optional<NodeOfFace> node_of_fitted_surface(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const std::vector<FacingPolygon>& polygons);

}  // namespace ffcontact
