// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/remeshing/dividing_edges.hpp"

namespace ffcontact {

/// Numbers of dividing faces.
using FaceNumbers = std::vector<int>;

/// The patches of each surface (SurfacePatches): itself, or halves across its longest extent
/// until each piece is one, with a rim and without handles.
/// @param surfaces  their faces
std::vector<std::vector<FaceNumbers>> patches_of(
    const SolidMesh& mesh, const Facets<3>& faces,
    const DividingFaces& dividing, const std::vector<DividingEdge>& edges,
    const std::vector<FaceNumbers>& surfaces);

}  // namespace ffcontact
