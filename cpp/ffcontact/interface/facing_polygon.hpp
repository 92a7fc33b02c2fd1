// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// A polygon of the common refinement of two facing surfaces: the part of a contact face
/// that faces a part of one face of the opposite body along the contact direction. Places
/// on faces are barycentric coordinates; those on the two faces and the distance
/// correspond linearly.
struct FacingPolygon {
  int contact_face;    ///< number on the contact surface
  int opposite_face;   ///< facet of the mesh
  double area;         ///< of the part of the contact face [mm^2]
  Matrix3Xd own;       ///< corners on the contact face [3 x k]
  Matrix3Xd opposite;  ///< corners on the opposite face [3 x k]
  VectorXd
      distance;  ///< from the first to the second, along the direction [mm, k]
  /// the vertices of the opposite face on the plane of the contact face: a place eta of
  /// the former lies at own_of_opposite eta of the latter
  Matrix3d own_of_opposite;
};

}  // namespace ffcontact
