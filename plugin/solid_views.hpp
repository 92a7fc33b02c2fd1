// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/interface/contact_surface.hpp"
//
#include "freefem.hpp"

namespace ffcontact::plugin {

/// FreeFEM's mesh3; column e of SolidMesh::boundary is FreeFEM's boundary element e.
/// Coordinates are those of take_from_near_origin.
/// @throws std::invalid_argument  if the mesh was never assigned
SolidMesh solid_mesh_of(const Fem2D::Mesh3* mesh);

/// A FreeFEM mesh3 and what the core made of it.
struct SolidView {
  const Fem2D::Mesh3& fem_mesh;
  const SolidMesh& mesh;
  const Facets<3>& faces;
};

/// An expression of the script at the nodes of a contact surface [p]: x, y, z, N, label
/// and region are those of the first contact face at the node.
/// @return an array of `otherwise` where the expression is null
VectorXd at_nodes(Stack stack, Expression expression, const SolidView& solid,
                  const ContactSurface& surface, double otherwise);

}  // namespace ffcontact::plugin
