// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// Two traces in contact, paired along the contact directions n of the first: x faces y =
/// x + s n, s > 0 where they are apart. The traces need not lie on each other (curved
/// bodies, initial gaps), their vertices need not match, and either may go on where the
/// other ends. Ends that all but meet a vertex, within 1e-4 of its edge, are taken for
/// it.
///
/// Of several edges on a ray the one that x is inside of, or touches, comes first, then the
/// nearest in front (s > 0); LineOfSight says which are faced at all, so that no body
/// faces anything through itself. Each piece between rays through opposite vertices is
/// decided at its middle. Contact edges with a vertex of the opposite trace, as those at
/// the tips of a crack, face nothing: the jump at that vertex is 0 by itself.
///
/// The gap is that of the curves c that the edges are chords of, (c_2 - c_1) . n at the
/// ends of a piece: between polygons it is off by the edges' heights over their chords,
/// which on curves that fit is as large as the gap.
struct FacingTraces {
  std::vector<FacingPiece> pieces;  ///< contact edge by contact edge, ascending
  /// s at each node of the line, infinite where it faces nothing [mm]
  VectorXd gap;
};

/// @param opposite_labels  boundary labels of the opposite body
/// @param curves           of both bodies
/// @throws std::invalid_argument  if no point of the line faces an opposite edge, or all
///                                edges of the line have a vertex of an opposite one
FacingTraces facing_traces(const Mesh& mesh, const Edges& edges,
                           const ContactLine& line,
                           const std::vector<int>& opposite_labels,
                           const BoundaryCurves& curves = {});

/// A place on a contact edge.
struct TouchingPlace {
  int edge;        ///< of the mesh
  Vector2d place;  ///< in the mesh's coordinates [mm]
};

/// Where the line touches the front of an edge with one of the labels; nothing where it
/// touches none.
/// @throws std::invalid_argument  as contact_line
std::optional<TouchingPlace> touching_place(
    const Mesh& mesh, const Edges& edges, const ContactLine& line,
    const std::vector<int>& opposite_labels);

}  // namespace ffcontact
