// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// The body that each vertex belongs to, numbered from 0 on: vertices of one cell are of
/// one body.
template <int dim>
std::vector<int> body_of_each_vertex(const SimplexMesh<dim>& mesh);

}  // namespace ffcontact
