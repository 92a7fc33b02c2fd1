// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "freefem/freefem.hpp"
#include "pictures/vtu.hpp"

namespace ffcontact::plugin {

/// Writes a mesh3 with its labels and regions as physical tags, and fields on it, for
/// gmsh (MSH 2.2, text).
/// @throws std::invalid_argument  if the file cannot be written
void write_gmsh_fields(const std::filesystem::path& file,
                       const Fem2D::Mesh3& Th, const VtuCells& cells);

}  // namespace ffcontact::plugin
