// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Loads int f phi_i of a body force f at the vertices of each cell, vertex by vertex [N/mm, in
/// space N, d (d + 1) x cells].
template <int d>
using BodyLoadsOfCells = Matrix<double, d*(d + 1), Dynamic>;

/// Those of a force, lumped.
/// @param force  its values at the vertices [dofs]
template <int d>
BodyLoadsOfCells<d> lumped_loads(const SimplexMesh<d>& mesh,
                                 const VectorXd& force);

/// Adds them to the loads b [dofs]; no columns: none.
template <int d>
void add_body_loads(const SimplexMesh<d>& mesh,
                    const BodyLoadsOfCells<d>& loads, VectorXd& b);

/// Volumes int phi_i that belong to the dofs.
template <int d>
VectorXd lumped_volumes(const SimplexMesh<d>& mesh) {
  VectorXd volumes = VectorXd::Zero(mesh.vertices.size());
  const VectorXd one = VectorXd::Ones(volumes.size());
  add_body_loads(mesh, lumped_loads(mesh, one), volumes);
  return volumes;
}

}  // namespace ffcontact
