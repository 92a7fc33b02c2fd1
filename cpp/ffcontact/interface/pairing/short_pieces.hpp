// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// The pieces of a line without those shorter than 1e-4 of both edges: they come of
/// vertices that were meant to meet, and as triangles would be too thin to compute with.
/// Their neighbours on either edge take their place, if there are any, and what is left
/// free of an opposite edge is no shorter either.
std::vector<FacingPiece> without_short_pieces(const Mesh& mesh,
                                              const Edges& edges,
                                              const ContactLine& line);

}  // namespace ffcontact
