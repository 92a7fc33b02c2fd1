// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/interface/contact_line.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
//
#include "problem/stated_pairs.hpp"

namespace ffcontact::plugin {

/// What a script says itself instead of leaving it to curves.
struct SaidOfCurves {
  bool normal, gap;
};

/// Says at verbosity 1 which edges of a pair's labels are taken for smooth curves, and what
/// is taken from these; and which polygons may have been meant for curves.
/// @param corner  that the curves were found with [degrees]
/// @param own     the line of the first body
void report_curves(const JoinedMesh& joined, const Edges& edges,
                   const BoundaryCurves& curves, double corner,
                   const StatedPair& pair, const ContactLine& own,
                   const SaidOfCurves& said);

}  // namespace ffcontact::plugin
