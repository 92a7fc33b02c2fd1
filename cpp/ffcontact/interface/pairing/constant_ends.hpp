// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/flags.hpp"
#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// The same line without the nodes at its ends where it does not match what it faces: their
/// edges have the constant density of the next node [B. Wohlmuth, SIAM J. Numer. Anal. 38,
/// 2000]. Where an end is held on both sides its multiplier would have nothing to do but to
/// remove what two traces differ by beside it, and be as large as it takes. Two nodes are
/// left at least, which hold the moment of a body.
ContactLine with_constant_ends(const Mesh& mesh, const Edges& edges,
                               const ContactLine& line);

/// The same without the end nodes at some vertices, as where another multiplier holds the jump.
/// A line of one edge keeps one of its nodes.
/// @param held  1 at these vertices
ContactLine without_ends(const Mesh& mesh, const Edges& edges,
                         const ContactLine& line, const Flags& held);

}  // namespace ffcontact
