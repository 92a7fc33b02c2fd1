// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/estimate/error/deepest_node.hpp"

namespace ffcontact {

/// What u_hat of bonded solids needs beyond a displacement that is linear on the cells.
///
/// Between its vertices the body that follows (following_parts) moves by w with it,
///     w = h = u(y) - u(x) on its faces,
/// continuous, 0 at its vertices, and linear on each polygon. On a cell with a face there w is
/// linear on the tetrahedra of the polygons and the vertex across; on other cells around an
/// edge that is there, on those of the edge's parts and the edge across. Both are h along the
/// edge and linear towards the vertices across on the faces between these cells, so that w is
/// continuous, and where u + w is u_hat
///     |sigma_hat - C eps(u_hat)| <= |sigma_hat - C eps(u)| + |w|,   |w|^2 = int C eps(w) : eps(w).
/// On each of these tetrahedra w is the linear function on all of the cell that goes on from
/// it. A cell with several faces or edges there has the sum of their norms, or more.
struct BondedJump {
  double norm = 0;  ///< |w| [(N mm)^(1/2)]
  /// The jump that is left, and a node near: where faces are covered in part alone, or face
  /// different places along their common edge, supports hold what should follow, what is
  /// followed follows another body, or w would go on into a face on which bodies slide.
  DeepestNode left;
};

/// @param surface       what of it is bonded
/// @param displacement  bonded_displacement
/// @param slides        1 at the facets of the mesh on which bodies slide, on either side; none:
///                      nowhere
BondedJump bonded_jump(const Topology<3>& topology,
                       const ContactSurface& surface,
                       const HookeTensors<3>& hooke, const Flags& prescribed,
                       const Ref<const VectorXd>& displacement,
                       const Flags& slides = {});

}  // namespace ffcontact
