// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Takes the coordinates of a mesh that is far from zero from an origin near it, without
/// rounding: sums of coordinates, as in centroids, would lose the digits that the
/// distance takes. A mesh within a few sizes of zero keeps its own.
template <int dim>
void take_from_near_origin(SimplexMesh<dim>& mesh);

}  // namespace ffcontact
