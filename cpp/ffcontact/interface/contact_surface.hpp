// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/interface/facing_polygon.hpp"
#include "ffcontact/interface/weights_by_node.hpp"
#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// The boundary part Gamma_C of a solid on which contact may occur, as a list of nodes
/// that carry forces.
///
/// Faces that meet at a blunt edge (more than 150 degrees inside the body) and have one
/// label, or lie in one plane, are of one smooth sheet. A node is a vertex of one sheet:
/// where sheets meet at an edge a vertex is a node of each of them, with its normal, and
/// keeps clear of what each of them faces. The normal is that of the sheet where it is a
/// plane, otherwise that of the smooth surface (fitted_normals). Against another
/// body only what faces it belongs to the surface (facing_surface).
struct ContactSurface {
  VectorXi vertex;   ///< mesh vertex of each node [p]
  Matrix3Xd normal;  ///< outward unit normal at each node [3 x p]
  VectorXd area;     ///< A_i = int phi_i over the faces of its sheet [mm^2, p]
  /// nodes of each contact face, -1 where a corner is none [3 x m]
  Matrix3Xi face_node;
  VectorXi face;      ///< its facet of the mesh, in that order of vertices [m]
  SparseMatrix mass;  ///< int phi_i phi_k over the faces of both [mm^2, p x p]
  /// What is taken from the displacement of a node's vertex to give the jump [u] there,
  /// the same for all components [p x vertices]; no rows where all of the foundation is
  /// rigid.
  WeightsByNode opposite;
  /// of its faces, in their order: what faces what; none where all of the foundation is
  /// rigid
  std::vector<FacingPolygon> polygons;

  int node_count() const { return static_cast<int>(vertex.size()); }
  int face_count() const { return static_cast<int>(face.size()); }
  bool against_a_body() const { return opposite.rows() > 0; }
  /// Columns n, t1, t2: t1 is the x axis seen along n (the y axis where that is within 26
  /// degrees of n), t2 = t1 x n. For n = -z these are x and y.
  Matrix3d frame(int node) const;
};

/// @throws std::invalid_argument  if `labels` is empty or one of them is on no boundary
///                                face of the body
ContactSurface contact_surface(const SolidMesh& mesh, const Facets<3>& faces,
                               const std::vector<int>& labels);

/// The surface with one node a vertex and given contact directions in place of normals:
/// u_n, u_t and the gap are measured along them.
/// @param direction  of any length, pointing out of the body on the faces beside its
///                   vertex, one column for each vertex of the mesh; those that are not
///                   on the surface are not read
/// @throws std::invalid_argument  as contact_surface, and naming the first vertex whose
///                                direction is zero, not finite, or points into the body
ContactSurface surface_along(const SolidMesh& mesh, const Facets<3>& faces,
                             const std::vector<int>& labels,
                             const Ref<const Matrix3Xd>& direction);

/// Components along n, t1, t2 at the nodes [3 x p] of a vertex field (3 vertex +
/// component) against the opposite body: of [u] = u - opposite u, with u = 0 in a rigid
/// foundation.
Matrix3Xd contact_components(const ContactSurface& surface,
                             const Ref<const VectorXd>& field);

/// Forces (F_n, F_t1, F_t2) at the nodes [3 x p] as a load on all dofs, those of opposite
/// bodies included.
VectorXd nodal_load(const ContactSurface& surface,
                    const Ref<const Matrix3Xd>& force, Index dofs);

}  // namespace ffcontact
