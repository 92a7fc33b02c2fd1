// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// The cubic triangle through three points with these normals there [A. Vlachos et al.,
/// Curved PN triangles, Proc. Symp. Interactive 3D Graphics, 2001, (1) to (3)]: along a
/// side it depends on that side's ends alone, so that neighbours meet without a gap; there
/// it is SmoothCurve's cubic instead of theirs. On a sphere of radius R with sides h it is
/// off by less than 0.01 h^4/R^3.
/// @param corners, normals  one column each; normals are of length 1
/// @param place             barycentric
Vector3d point_on_cubic_triangle(const Matrix3d& corners,
                                 const Matrix3d& normals,
                                 const Vector3d& place);

/// The point of a triangle that is nearest to x, barycentric.
Vector3d nearest_place(const Matrix3d& corners, const Vector3d& x);

}  // namespace ffcontact
