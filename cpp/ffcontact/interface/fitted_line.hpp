// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// An edge of a curved line, and its height over its chord.
struct CurvedEdge {
  int edge;        ///< of the mesh
  double sagitta;  ///< length times turn / 8 [mm]
};

/// The edge of a line that fits what it faces, as node_of_fitted_surface: its contact
/// directions n turn, and the opposite normals m turn with them,
///     1/2 < (sum a . b) / (sum a . a) < 2,   a = n_j - n_i,  b = m_i - m_j
/// over the contact edges i, j with |a| > 0.01: 1 for a pin in its bore, 0 on a straight
/// line. The gap along n between the edges of both is then off that of the curves by as
/// much as their sagittas, which on a curve that fits is as large as the gap itself.
/// @param pieces  of facing_traces, of two traces whose edges face each other one by one
///                the gap has no such error
/// @return the one with the largest sagitta
std::optional<CurvedEdge> edge_of_fitted_line(
    const Mesh& mesh, const Edges& edges, const ContactLine& line,
    const std::vector<FacingPiece>& pieces);

}  // namespace ffcontact
