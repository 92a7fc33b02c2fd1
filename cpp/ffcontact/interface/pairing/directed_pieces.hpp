// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// A piece with the contact directions at its ends.
struct DirectedPiece {
  FacingPiece piece;
  Vector2d n_begin, n_end;
};

/// Pieces with the contact directions of a line at their ends, which are on its edges.
std::vector<DirectedPiece> directed(const ContactLine& line,
                                    const std::vector<FacingPiece>& pieces);

/// Whether a piece begins where the one before it on the same contact edge ends.
bool go_on(const DirectedPiece& before, const DirectedPiece& after);

/// Where the opposite trace ends within 1e-4 of an edge from a vertex of the line it ends
/// there: what little is left of the edge beyond the end belongs to the last piece, what
/// little of it is beyond the vertex to the piece before the vertex. Holes as narrow between
/// two pieces of an edge, as at a joint of two opposite bodies, are closed.
/// @param pieces  ascending
std::vector<DirectedPiece> without_slivers(std::vector<DirectedPiece> pieces);

}  // namespace ffcontact
