// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// The functions that carry nodal values on one contact face: the hat of each corner that
/// is a node, and equal shares of those that are none,
///     chi_a = sum over the corners of hat(k, a) phi_k,   sum chi_a = 1.
/// Linear between values in a convex set is in it.
struct FaceHats {
  std::vector<int> node;  ///< one to three
  Matrix3Xd hat;          ///< one column each
};
FaceHats face_hats(const ContactSurface& surface, int contact_face);

/// The traction at the corners of a contact face along x, y, z [MPa].
/// @param traction  (r_n, r_t1, r_t2) at the nodes [MPa, 3 x p]
Matrix3d traction_at_corners(const ContactSurface& surface, int contact_face,
                             const Ref<const Matrix3Xd>& traction);

/// What a traction D phi on a contact face does to one mesh face: with the hats of its
/// three vertices the moments are the columns of D weight. On its own face weight = int
/// phi phi', over what faces the opposite body; on a face of that body it is -int phi
/// eta' over the polygons that they share, eta its barycentric coordinates: both bodies
/// feel the same forces, in opposite directions.
struct TractionPart {
  int contact_face;
  int face;         ///< of the mesh
  Matrix3d weight;  ///< [mm^2]
};
std::vector<TractionPart> traction_parts(const SolidMesh& mesh,
                                         const Facets<3>& faces,
                                         const ContactSurface& surface);

/// The triangles of a polygon from its first corner: three of its corners each, and the
/// part of its face's area that they have.
/// @param corners  barycentric [3 x k]
struct FanTriangle {
  Vector3i corner;
  double share;
};
std::vector<FanTriangle> fan_of(const Ref<const Matrix3Xd>& corners);

}  // namespace ffcontact
