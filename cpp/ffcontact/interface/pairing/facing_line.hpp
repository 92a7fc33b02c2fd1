// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/interface/pairing/facing_traces.hpp"

namespace ffcontact {

/// The part of the line that faces the opposite body, with that body behind it
/// (with_opposite).
///
/// Edges that face nothing are left out, and of an edge that the opposite body ends in
/// only the facing part is a contact edge, so that no traction acts where nothing faces
/// it. On that part psi of the node that it shares with the edge beside it is 1:
/// multipliers go on as constants, as they do at the ends of mortar lines where nodes are
/// prescribed (B. Wohlmuth, SIAM J. Numer. Anal. 38, 2000), for the trace of one edge
/// cannot hold two independent multipliers a small distance apart. Only where the edge
/// beside it does not face more of itself are they linear there, with a node at the end
/// that moves as the edge does.
ContactLine facing_line(const Mesh& mesh, const Edges& edges,
                        const ContactLine& line, const FacingTraces& traces);

/// The opposite trace of a facing line as the line, with the same pieces: what faces each
/// other, the gap, u_n, u_t and tractions stay what they are, n turns its sign with the
/// body. Nothing where two parts of the line face one place of the opposite body.
/// @param opposite_labels  those of facing_traces
std::optional<ContactLine> exchanged_line(
    const Mesh& mesh, const Edges& edges, const ContactLine& line,
    const std::vector<int>& opposite_labels);

}  // namespace ffcontact
