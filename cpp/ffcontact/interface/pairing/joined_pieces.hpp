// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/pairing/directed_pieces.hpp"

namespace ffcontact {

/// The line whose contact edges are the pieces of one mesh edge that go on from each
/// other in one direction, with the pieces themselves; what they face is left out
/// (with_opposite).
///
/// On an edge of which only a part is left psi of the node that it shares with the edge
/// beside it is 1, unless that one has still less of itself: then psi are linear, with a
/// node at the end that moves as the edge does.
/// @param whole  the line that the pieces number edges of
/// @param pieces  ascending
ContactLine joined_pieces(const Edges& edges, const ContactLine& whole,
                          const std::vector<DirectedPiece>& pieces);

}  // namespace ffcontact
