// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views.hpp"

namespace ffcontact::plugin {

/// What every script function that knows of contact takes: a mesh and label=, friction=, slipbound=, gap=, normal=[nx, ny] (one
/// contact direction a vertex in place of the edges' normals), previous= (displacement of the load step before; an empty array
/// is none).
struct ContactArguments {
  Mesh mesh;
  Edges edges;
  ContactLine line;
  ContactLaw law;  ///< multiplier left at its default

  /// The common parameters followed by a function's own.
  static NamedArguments::Table table(const NamedArguments::Table& own);

  /// @throws std::invalid_argument  if the mesh, a label or a coefficient is not usable
  ContactArguments(Stack stack, const NamedArguments& named, const Fem2D::Mesh* fem_mesh);

  /// @throws std::invalid_argument  if `count` is not the number of dofs of [P1, P1] on the mesh
  void require_dofs(const char* name, Eigen::Index count) const;

  /// Nodal pressures from the script's pn and pt [2 x p].
  Eigen::Matrix2Xd pressures(KN<double>* normal, KN<double>* tangential) const;
};

}  // namespace ffcontact::plugin
