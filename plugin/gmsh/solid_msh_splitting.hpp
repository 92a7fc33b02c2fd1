// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "gmsh/msh_file.hpp"

namespace ffcontact::plugin {

/// Puts tetrahedra in place of the hexahedra, prisms and pyramids of a file, with their
/// tags; new nodes in the middle of cells follow the others.
/// @return the number of new nodes
/// @throws std::invalid_argument  if a cell is flat or folded
int split_solid_cells(MshFile& file, const std::string& shown);

}  // namespace ffcontact::plugin
