// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/interface/contact_line.hpp"

/// Lines along which bodies are bonded. Neither u = 0 nor tractions of any direction
/// depend on n: it says what faces what, and along what multipliers are given.
namespace ffcontact {

/// One node a vertex, corners included: what is glued there once is glued. Its n is that of
/// the straight line that it lies within, or the unit mean of those of the two lines that
/// meet there.
/// @throws std::invalid_argument  as contact_line
ContactLine bonded_line(const Mesh& mesh, const Edges& edges,
                        const std::vector<int>& labels);

/// A line on which no edge has directions that turn.
struct UnturnedLine {
  ContactLine line;
  VectorXi parent;  ///< node of the given line for each node [p]
};

/// The same line with two nodes of their own for each bonded edge along which directions
/// turn, with the normal of the edge: tractions that are linear on edges jump at corners. New
/// nodes follow the old ones, so that vertices come in the same order.
/// @param bonded  1 at the nodes that are
UnturnedLine unturned_line(const Mesh& mesh, const Edges& edges,
                           const ContactLine& line, const Flags& bonded);

/// Do directions turn along an edge that is bonded?
bool bonded_part_turns(const ContactLine& line, const Flags& bonded);

}  // namespace ffcontact
