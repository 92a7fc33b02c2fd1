// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/joined_mesh.hpp"
//
#include "views.hpp"

namespace ffcontact::plugin {

/// The name of a parameter of one body: itself where there is one body, otherwise followed by the body's number from 1. It
/// stays valid.
const char* name_of_body(const char* name, int body, int bodies);

/// Parameters that every body has, named for each of them.
NamedArguments::Table for_bodies(const NamedArguments::Table& parameters, int bodies);

/// Reads multiplier=: what pn and pt stand for.
/// @throws std::invalid_argument  if it is neither "force" nor "pressure"
Multiplier multiplier_of(Stack stack, const NamedArguments& named);

/// What every script function that knows of contact takes: one mesh or several, and label=, friction=, slipbound=, gap=,
/// normal=[nx, ny] (one contact direction a vertex in place of the edges' normals), previous= (displacement of the load step
/// before; an empty array is none).
///
/// One mesh: label= faces a rigid foundation, or the labels opposite= of the same mesh, which then is of bodies that share no
/// vertex. Several meshes: body k faces body k + 1, with label1=, label2=, ... in place of label=; of three bodies those between
/// have two labels, the first faces the body before, the second the one after. Coefficients are those of the body that comes
/// first. Without gap= the gap against a body is that of the meshes.
struct ContactArguments {
  JoinedMesh joined;
  const Mesh& mesh = joined.mesh;
  std::vector<const Fem2D::Mesh*> fem_meshes;
  Edges edges;
  ContactLine line;
  ContactLaw law;                ///< multiplier left at its default
  std::vector<long> own_vertex;  ///< of each node in its own mesh

  /// The common parameters followed by a function's own.
  static NamedArguments::Table table(const NamedArguments::Table& own, int bodies = 1);

  /// @throws std::invalid_argument  if a mesh, a label or a coefficient is not usable
  ContactArguments(Stack stack, const NamedArguments& named, const std::vector<const Fem2D::Mesh*>& meshes);
  ContactArguments(const ContactArguments&) = delete;
  ContactArguments& operator=(const ContactArguments&) = delete;

  int body_count() const { return joined.body_count(); }
  Eigen::Index first_dof(int body) const { return 2 * joined.first_vertex[body]; }
  Eigen::Index dof_count(int body) const { return first_dof(body + 1) - first_dof(body); }

  /// @throws std::invalid_argument  if `count` is not the number of dofs of [P1, P1] on the mesh of a body
  void require_dofs(const char* name, int body, Eigen::Index count) const;

  /// Nodal pressures from the script's pn and pt [2 x p].
  Eigen::Matrix2Xd pressures(KN<double>* normal, KN<double>* tangential) const;

 private:
  void add_pair(Stack stack, const NamedArguments& named, int body, const std::vector<int>& labels, int opposite_body,
                const std::vector<int>& opposite_labels, std::vector<ContactLine>& lines);
  void add_coefficients(Stack stack, const NamedArguments& named, int body, const ContactLine& line,
                        const Eigen::VectorXd& mesh_gap);
};

}  // namespace ffcontact::plugin
