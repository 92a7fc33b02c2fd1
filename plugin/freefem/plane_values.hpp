// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/interface/stated_places.hpp"
//
#include "freefem/arguments.hpp"
#include "freefem/boundary_places.hpp"

/// Expressions of the script at points of plane bodies.
namespace ffcontact::plugin {

/// One body of a joined mesh.
struct BodyPart {
  const Mesh& mesh;             ///< all bodies
  const Fem2D::Mesh* fem_mesh;  ///< null where other processes hold parts of it
  int body, first_boundary;
  const PlacesElsewhere<2>* elsewhere;  ///< null where fem_mesh is not
};

/// An expression at places of one body's boundary (x, y, label, N), which is here.
VectorXd at_boundary(Stack stack, Expression expression, const BodyPart& part,
                     const std::vector<BoundaryPlace<2>>& places);

/// An expression of the script at the nodes of a contact line (x, y, label, N as on the
/// boundary) [p].
/// @return an array of `otherwise` where the expression is null
VectorXd at_nodes(Stack stack, Expression expression, const BodyPart& part,
                  const Edges& edges, const ContactLine& line,
                  const StatedPlaces& places, double otherwise);

/// An expression at the places of each edge, with the label of the edge [points x edges].
MatrixXd along_edges(Stack stack, Expression expression, const BodyPart& part,
                     const Edges& edges, const StatedPlaces& places);

/// An expression at the centroid of each triangle (x, y, region) [triangles].
VectorXd at_triangles(Stack stack, Expression expression,
                      const Fem2D::Mesh& fem_mesh, double otherwise);

/// An expression at the points of the quadrature that FreeFEM's int2d uses by default, 0
/// where it is null [points x triangles].
MatrixXd at_quadrature_points(Stack stack, Expression expression,
                              const Fem2D::Mesh& fem_mesh);

/// An expression at places of every boundary element, from 0 at its first vertex to 1 at its
/// second (x, y, label, N), 0 where it is null [places x boundary].
MatrixXd along_boundary(Stack stack, Expression expression,
                        const Fem2D::Mesh& fem_mesh, const Mesh& mesh,
                        const std::vector<double>& places);

/// An expression at the three Gauss points of every boundary element, from its first
/// vertex to its second (x, y, label, N), 0 where it is null [3 x boundary].
MatrixXd at_gauss_points(Stack stack, Expression expression,
                         const Fem2D::Mesh& fem_mesh, const Mesh& mesh);

/// Moments int F phi of a traction at the two vertices of every boundary element [4 x
/// boundary], by the quadrature that FreeFEM's int1d uses by default (three Gauss
/// points), so that they are the loads of the script. Null components are zero.
Matrix4Xd traction_moments(Stack stack, Expression Fx, Expression Fy,
                           const Fem2D::Mesh& fem_mesh, const Mesh& mesh);

/// Body forces as the loads of the script.
struct BodyForce {
  /// int f phi_i per triangle, by the quadrature that FreeFEM's int2d uses by default
  BodyLoadsOfCells<2> loads;
  /// (sum over triangles of (h / pi)^2 |f - f~|^2)^(1/2), f~ the force of
  /// composite_stress [N]
  double oscillation;
};
BodyForce body_force_loads(Stack stack, Expression fx, Expression fy,
                           const Fem2D::Mesh& fem_mesh, const Mesh& mesh);

}  // namespace ffcontact::plugin
