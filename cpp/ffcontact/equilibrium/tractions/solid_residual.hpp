// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/mesh/solid_topology.hpp"

namespace ffcontact {

using Matrix6Xd = Matrix<double, 6, Dynamic>;
/// SolidBodyLoads per tetrahedron, column-major.
using SolidBodyLoadsOfAll = Matrix<double, 12, Dynamic>;

/// What the stresses of a finite element solution lack to be in equilibrium with the
/// loads, vertex by vertex, as NodalResidual in the plane:
///     missing_i = sum over the star of (int f phi_i - |T| sigma grad phi_i) + moments at i of the known boundary tractions.
/// Where a support answers, on a component that a boundary face at the vertex leaves free,
/// nothing is missing.
struct SolidResidual {
  Matrix3Xd missing;                         ///< [N, 3 x vertices]
  Eigen::Array<bool, 3, Dynamic> supported;  ///< where a support answers
  double scale;                              ///< largest term [N]
};

/// @param stress      per tetrahedron, Voigt [MPa]
/// @param body_loads  int_T f phi_i at the four vertices of each tetrahedron [N]
SolidResidual nodal_residual(const SolidTopology& topology,
                             const Ref<const Matrix6Xd>& stress,
                             const SolidBodyLoadsOfAll& body_loads,
                             const FaceTractions& boundary);

/// The same with forces on the vertices beside the boundary tractions.
/// @param forces  on all dofs [N]
SolidResidual with_forces(SolidResidual residual, const VectorXd& forces);

/// The same when a stress is added.
/// @param added  per tetrahedron, Voigt [MPa]
SolidResidual less_stress(const SolidTopology& topology, SolidResidual residual,
                          const Ref<const Matrix6Xd>& added);

/// |T| sigma grad phi_i - int_T f phi_i on each tetrahedron of the star of vertex i, in
/// its order [N, 3 x tetrahedra of the star].
Matrix3Xd star_loads(const SolidTopology& topology, int vertex,
                     const Ref<const Matrix6Xd>& stress,
                     const SolidBodyLoadsOfAll& body_loads);

}  // namespace ffcontact
