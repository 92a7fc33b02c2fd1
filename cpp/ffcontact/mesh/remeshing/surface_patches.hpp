// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/mesh/remeshing/dividing_edges.hpp"

namespace ffcontact {

/// Dividing faces as planes and smooth surfaces, and these as patches that a remesher can
/// flatten out: in one piece, with a rim, and without handles.
///
/// A surface is of one label between the same two parts of the body. A plane has a vertex
/// inside, all of whose faces turn by less than 0.1 degrees; such faces and all coplanar
/// ones beside them are a surface of their own. What is left goes on across edges at
/// which it turns by less than `corner`. A single face is a plane unless its surface goes on
/// beyond its label. A surface that closes on itself or has a handle
/// (a ball, a ring), or most of whose normals cancel inside one rim, is cut into patches.
struct SurfacePatches {
  std::vector<int> surface,
      patch;   ///< of each dividing face, numbered from 0 on
  Flags flat;  ///< 1 for each surface that is a plane
  std::vector<int> surface_of_patch;
  /// of each surface: smooth ones that were one surface if they had one label
  std::vector<int> sheet;
  /// 1 for each dividing edge at which a sheet that is no plane changes its label
  Flags is_label_line;

  int surface_count() const { return static_cast<int>(flat.size()); }
  /// Number of the sheet of each dividing face.
  int sheet_of_face(int k) const { return sheet[surface[k]]; }
  int patch_count() const { return static_cast<int>(surface_of_patch.size()); }
};

/// @param corner  [rad]
SurfacePatches surface_patches(const SolidMesh& mesh, const Facets<3>& faces,
                               const DividingFaces& dividing,
                               const std::vector<DividingEdge>& edges,
                               double corner);

}  // namespace ffcontact
