// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ffcontact/mesh/joined_mesh.hpp"

namespace ffcontact::plugin {

/// Says at any verbosity, once a statement, that a curved contact has not the directions
/// of its curve.
/// @param column  of the joined mesh's boundary, at the vertex
/// @param doubt   the rest of the sentence
template <int dim>
void warn_of_curve(const JoinedBodies<dim>& joined, int body, int vertex,
                   int column, const std::string& doubt);

}  // namespace ffcontact::plugin
