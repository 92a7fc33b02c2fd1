// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ffcontact/mesh/joined_mesh.hpp"

namespace ffcontact::plugin {

/// Says at any verbosity, once a statement, that the contact of a curved surface has not
/// its directions or its gap.
/// @param column  of the joined mesh's boundary, at the vertex
/// @param doubt   the rest of the sentence
void warn_of_curve(const JoinedSolids& joined, int body, int vertex, int column,
                   const std::string& doubt);

}  // namespace ffcontact::plugin
