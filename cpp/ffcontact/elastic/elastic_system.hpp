// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/elastic/prescribed_dofs.hpp"

namespace ffcontact {

/// A linear elastic body before contact: K u = b on the free dofs, u = value on the
/// prescribed ones; dofs are numbered as in dofs.hpp.
struct ElasticSystem {
  /// K [N/mm; per unit thickness in the plane]; rows and columns of prescribed dofs are not used
  MovableMatrix stiffness;
  /// b with the prescribed columns moved to the right, 0 on prescribed dofs [N/mm]
  VectorXd load;
  Flags prescribed;           ///< 1 where the dof is prescribed
  VectorXd prescribed_value;  ///< [mm], 0 on free dofs
  int dimension = 2;          ///< of the body: dofs of a vertex

  int dof_count() const { return static_cast<int>(load.size()); }
};

/// The system as FreeFEM assembles it: prescribed_dofs have the value b / diagonal.
/// @param A          moved into the system, whose stiffness it is
/// @param dimension  2 or 3, of the body
/// @throws std::invalid_argument  if sizes differ or are no multiple of the dimension, a
///                                value of A or b is not finite, A is not symmetric on
///                                the free dofs or has a negative diagonal there, a
///                                prescribed value is not zero where the columns of A are
///                                gone (tgv = -2), or such a matrix was scaled and has
///                                free dofs without free neighbours
ElasticSystem elastic_system(MovableMatrix A, const Ref<const VectorXd>& b,
                             int dimension = 2);

/// Refuses what only A and b with different tgv have: prescribed displacements beyond all
/// proportion to the mesh, or loads that move it so far.
/// @param extent  of the mesh [mm]
/// @throws std::invalid_argument  if they are
void require_same_tgv(const ElasticSystem& system, double extent);

/// Forces on all dofs, 0 on the prescribed ones.
VectorXd on_free_dofs(const ElasticSystem& system, VectorXd forces);

Index free_dof_count(const ElasticSystem& system);

/// The free dofs of vertices, each once, in the order of these.
std::vector<int> free_dofs_at(const std::vector<int>& vertices,
                              const ElasticSystem& system);

/// Several bodies as one system of separate blocks, in the order of joined_mesh.
/// @throws std::invalid_argument  if their dimensions differ
ElasticSystem joined_systems(const std::vector<ElasticSystem>& bodies);

}  // namespace ffcontact
