// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/facets.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
//
#include "problem/curve_report.hpp"

namespace ffcontact::plugin {

/// Says at verbosity 1 which labels of a pair of solids are smooth surfaces, how far these are
/// beside their faces, and what is taken from them.
void report_surfaces(const JoinedSolids& joined, const Facets<3>& faces,
                     const StatedPair& pair, const SaidOfCurves& said);

}  // namespace ffcontact::plugin
