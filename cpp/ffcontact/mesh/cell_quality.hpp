// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Radius of the inscribed circle or sphere over the longest edge, for each cell, over
/// that of a regular one, 1/sqrt(12) or 1/sqrt(24): 1 for a regular cell, 0 for a flat one;
/// 0.72 for half a square, 0.59 for a sixth of a cube.
template <int dim>
VectorXd cell_quality(const SimplexMesh<dim>& mesh);

}  // namespace ffcontact
