// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// The face of another body that a contact face faces, where that is the same triangle,
/// moved: y = x + d at all corners, d along the contact direction.
struct MatchingFace {
  int face = -1;  ///< of the mesh; -1: none matches
  /// of it, which each corner of the contact face faces
  Vector3i corner = Vector3i::Zero();
};

/// For each contact face. Faces match that face nothing but each other, and whose corners
/// are all nodes; d is the same at all corners to 1e-11 of the triangle's height.
std::vector<MatchingFace> matching_faces(const SolidMesh& mesh,
                                         const Facets<3>& faces,
                                         const ContactSurface& surface);

}  // namespace ffcontact
