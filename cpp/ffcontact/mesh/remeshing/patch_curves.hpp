// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/remeshing/surface_patches.hpp"

namespace ffcontact {

/// A chain of edges in which the same patches meet, from a corner to the next.
struct PatchCurve {
  std::vector<int> vertices;  ///< in order; the first again where it is closed
  std::vector<int> patches;  ///< ascending, each as often as it has faces there
  /// 1 where it is the rim of surfaces; 0 where it cuts a surface into patches
  bool is_rim = true;
  /// does nothing but a label change there, on a smooth sheet?
  bool is_label_line = false;
};

struct PatchCurves {
  std::vector<PatchCurve> curves;
  std::vector<int> corners;  ///< vertices at which curves end, ascending
};

/// Corners are where other than two edges of the curves meet, where other patches begin,
/// where a curve turns by more than `corner` [rad], and where it turns by more than a
/// degree beside a straight line of several edges. A closed curve without any has one all
/// the same.
PatchCurves patch_curves(const SolidMesh& mesh,
                         const std::vector<DividingEdge>& edges,
                         const SurfacePatches& patches, double corner);

}  // namespace ffcontact
