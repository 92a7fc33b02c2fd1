// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/remeshing/boundary_parts.hpp"

namespace ffcontact {

/// A mesh of the same body with labels of parts, its vertices on them: where two parts
/// meet on their common end, otherwise on the chord of a straight line, or on the smooth
/// curve. Inner vertices near the boundary give way where triangles would suffer.
/// @throws std::invalid_argument  naming a triangle that would be turned over
Mesh moved_onto_parts(Mesh fine, const Mesh& mesh,
                      const std::vector<BoundaryPart>& parts);

}  // namespace ffcontact
