// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"

/// Random solids in contact, assembled by plain loops.
namespace ffcontact::fuzz {

/// What a boundary face carries.
struct OnFace {
  Vector3d traction = Vector3d::Zero();  ///< [MPa]
};

/// One problem as scripts state it. Everything follows from seed and index.
struct SolidCase {
  std::string kind;  ///< in words, for the table
  bool promised =
      false;      ///< supports hold every body, and friction is moderate
  int steps = 8;  ///< of the relaxation
  SolidMesh mesh;
  Facets<3> faces;
  ContactSurface surface;
  ContactLaw<3> law;
  HookeTensors<3> hooke;
  std::vector<OnFace> on_face;             ///< of each boundary face
  Vector3d body_force = Vector3d::Zero();  ///< [N/mm^3]
  Flags prescribed;
  VectorXd value;       ///< of prescribed dofs
  RowMatrix stiffness;  ///< without prescribed dofs
  VectorXd load;

  RowMatrix A() const;  ///< with 1e30 on prescribed diagonals
  VectorXd b() const;
  FaceMoments neumann() const;
  BodyLoadsOfCells<3> body_loads() const;
};

/// @throws what the library throws where a surface is stated
SolidCase random_solid(std::uint64_t seed, std::uint64_t index);

/// The same body with eight tetrahedra for each, the same loads and supports, against the
/// same rigid plane: contact nodes are on `label`s faces.
SolidCase refined_once(const SolidCase& coarse, const std::vector<int>& labels);

/// Labels of the contact faces of a body on a rigid plane.
std::vector<int> contact_labels(const SolidCase& problem);

/// Gradients of the four hats [3 x 4] and the volume of a tetrahedron.
struct Hats {
  Eigen::Matrix<double, 3, 4> gradient;
  double volume;
};
Hats hats_of(const Eigen::Matrix<double, 3, 4>& corners);

Eigen::Matrix<double, 3, 4> corners_at(const SolidMesh& mesh, int cell);

/// Engineering strain xx, yy, zz, yz, xz, xy of a displacement.
VoigtVector<3> strain_at(const SolidMesh& mesh, int cell, const VectorXd& u);

/// sigma in Voigt's order as a tensor.
Matrix3d tensor_of(const VoigtVector<3>& stress);

}  // namespace ffcontact::fuzz
