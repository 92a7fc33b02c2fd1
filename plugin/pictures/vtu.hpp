// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// Values at points or on cells, one column each: one row is a number, three are a
/// vector.
struct VtuField {
  std::string name;
  MatrixXd values;
};

/// Triangles or tetrahedra for ParaView.
struct VtuCells {
  Matrix3Xd points;  ///< [mm]
  MatrixXi corners;  ///< points of each cell, three or four
  std::vector<VtuField> on_points, on_cells;
};

/// Writes a VTK XML file (UnstructuredGrid, ascii, all digits).
/// @throws std::invalid_argument  if the file cannot be written
void write_vtu(const std::filesystem::path& file, const VtuCells& cells);

}  // namespace ffcontact::plugin
