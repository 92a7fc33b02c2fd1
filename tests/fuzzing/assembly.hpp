// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "case.hpp"
#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/contact/rigid_tool.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/interface/joined_contact.hpp"
#include "ffcontact/interface/line_ends.hpp"
#include "ffcontact/interface/pairing/facing_line.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"

namespace ffcontact::fuzz {

using Dense = MatrixXd;

/// A case as the library takes it, beside the same integrals by plain loops of our own.
struct Assembled {
  JoinedMesh joined;
  Edges edges;
  ContactLine line;
  ContactLaw<2> law;
  /// per triangle of the joined mesh: its place in `elasticity`
  std::vector<int> region;
  /// C, Voigt with engineering shear, by our own formula
  std::vector<Matrix3d> elasticity;
  Hooke hooke;                   ///< C per triangle
  SparseMatrix stiffness;        ///< K without supports, our own
  VectorXd load;                 ///< of tractions and body forces
  std::vector<char> prescribed;  ///< per dof
  VectorXd value;                ///< of prescribed dofs, 0 elsewhere
  RowMatrix A;                   ///< with supports, as FreeFEM's tgv puts them
  VectorXd b;
  Matrix4Xd
      neumann;  ///< moments of the tractions at the ends of each boundary edge
  Matrix2Xd body_force;  ///< per triangle
  std::optional<RigidTool> tool;
  VectorXd before_tool;  ///< `previous` before it moved

  const Mesh& mesh() const { return joined.mesh; }
  SolvedBody<2> solved(const ContactSolution<2>& solution) const;
  /// A vertex in the coordinates of a coarser or finer mesh of the same bodies: joined
  /// meshes choose their origin.
  Vector2d point_in(const Assembled& other, int vertex) const;
};

/// With a tool, the law is then that against the foundation where it has moved it.
ContactSolution<2> solved_contact(Assembled& parts,
                                  const ElasticSystem& system);

/// @throws std::invalid_argument  where the library refuses mesh, line or traces
Assembled assembled(const Case& problem);

/// The case on the mesh of which every triangle is cut into four, with the same line, law
/// and loads: what is given at nodes is linear in between.
struct Refined {
  Case problem;
  Assembled parts;
};
Refined refined(const Case& problem, const Assembled& coarse);

/// Value at a point of a function that is linear on the edges of the line, on its edge
/// with this normal.
double value_on_line(const Assembled& parts, const VectorXd& values,
                     const Vector2d& point, const Vector2d& normal);

/// Plane strain, by E and nu.
Matrix3d elasticity_of(const Material& material);

}  // namespace ffcontact::fuzz
