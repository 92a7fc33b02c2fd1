// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Of a body: translations and rotations.
template <int dim>
constexpr int motion_count = dim*(dim + 1) / 2;

/// The rotations about the axes at r, one column each: e_z x r in the plane, e_k x r in
/// space.
template <int dim>
Matrix<double, dim, motion_count<dim> - dim> rotations(const VectorOf<dim>& r) {
  if constexpr (dim == 2) return Vector2d(-r.y(), r.x());
  Matrix<double, dim, motion_count<dim> - dim> result;
  if constexpr (dim == 3)
    for (int k = 0; k < 3; ++k) result.col(k) = Vector3d::Unit(k).cross(r);
  return result;
}

/// Basis of the rigid motions that no prescribed dof stops, one column each [dofs x k], k
/// = 0 to 3 per connected part in the plane, 0 to 6 in space. A motion a + w x (x - c)
/// about the part's centre c is scaled to a largest displacement of about 1.
/// @param prescribed  1 where the dof is prescribed [dofs]
template <int dim>
MatrixXd free_rigid_motions(const SimplexMesh<dim>& mesh,
                            const Flags& prescribed);

/// "translation along (0, 1)" or "rotation about (10, 5)": a rigid motion in words. In
/// space "rotation about (0, 0, 1) through (10, 5, 0)", the axis by its direction, about
/// which the motion turns right-handed, and its point nearest to the body's centre; a
/// screw motion goes on with ", 3 mm a turn" along that direction.
/// @param motion  a combination of columns of free_rigid_motions, not zero [dofs]; of
///                several parts that move the first one is described
template <int dim>
std::string motion_in_words(const SimplexMesh<dim>& mesh,
                            const Ref<const VectorXd>& motion);

}  // namespace ffcontact
