// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// The rectangle (0, size) of cells, each cut by the diagonal from lower left to upper
/// right, as FreeFEM's square(): its sides are labelled 1 below, 2 right, 3 above, 4 left.
/// @throws std::invalid_argument  if there is no cell, or a size is not positive
Mesh rectangle(const Vector2i& cells, const Vector2d& size);

}  // namespace ffcontact
