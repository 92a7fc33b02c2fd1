// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// Values at points or on triangles, one column each: one row is a number, three are a
/// vector.
struct VtuField {
  std::string name;
  MatrixXd values;
};

/// Triangles in the plane for ParaView.
struct VtuTriangles {
  Matrix2Xd points;                        ///< [mm]
  Eigen::Matrix<int, 3, Dynamic> corners;  ///< points of each triangle
  std::vector<VtuField> on_points, on_triangles;
};

/// Writes a VTK XML file (UnstructuredGrid, ascii, all digits).
/// @throws std::invalid_argument  if the file cannot be written
void write_vtu(const std::filesystem::path& file,
               const VtuTriangles& triangles);

}  // namespace ffcontact::plugin
