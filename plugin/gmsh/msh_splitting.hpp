// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "gmsh/msh_file.hpp"

namespace ffcontact::plugin {

/// Puts triangles in place of the quadrangles of a file, with their tags.
/// @param shown  what the user calls the file
/// @throws std::invalid_argument  if a quadrangle is flat or crosses itself
void split_quadrangles(MshFile& file, const std::string& shown);

/// "12 hexahedra and 1 prism were split into 75 tetrahedra"; nothing where all were
/// simplices.
std::string splitting_in_words(const std::vector<MshElement>& before,
                               const std::vector<MshElement>& after);

}  // namespace ffcontact::plugin
