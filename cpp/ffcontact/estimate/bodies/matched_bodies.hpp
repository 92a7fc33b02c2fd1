// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/interface/pairing/common_refinement.hpp"

namespace ffcontact {

/// The bodies on which admissible fields are built.
template <int d>
class MatchedBodies;

/// Plane bodies with facing traces that match: as they are solved where the traces match, and
/// their common refinement where they do not.
template <>
class MatchedBodies<2> {
 public:
  /// @param solved  stays where it is
  explicit MatchedBodies(const SolvedProblem<2>& solved);

  const Topology<2>& topology() const {
    return cut_ ? cut_->topology : solved_.topology;
  }
  const ContactLine& contact() const {
    return cut_ ? refinement_->line : solved_.contact;
  }
  const SolvedBody<2>& body() const { return cut_ ? cut_->body : solved_.body; }
  const Flags& prescribed() const {
    return cut_ ? cut_->prescribed : solved_.system.prescribed;
  }

  const ContactLine& solved_line() const { return solved_.contact; }
  const ContactLaw<2>& solved_law() const { return solved_.body.law; }
  /// Length of the solved contact edge that a contact edge is a part of [mm].
  double solved_length(int e) const {
    return solved_.contact
        .length[cut_ ? refinement_->parent_contact_edge[e] : e];
  }
  /// Is it a vertex at which an edge was cut?
  bool is_cut(int vertex) const {
    return vertex >= solved_.topology.mesh.vertex_count();
  }

  /// Moments of the springs' tractions [4 x Mesh::boundary], of those that answer u_h at
  /// first.
  Matrix4Xd& spring_tractions() { return springs_; }
  const Matrix4Xd& spring_tractions() const { return springs_; }
  /// They change by so much on the solved bodies.
  void add_to_springs(const Matrix4Xd& change);

  /// What the boundary carries with these contact tractions.
  BoundaryTractions boundary_with(const ContactDensities& densities) const;

  /// The same on the solved mesh, and without those of contact, with which all components of
  /// contact edges are known.
  BoundaryTractions solved_boundary(const BoundaryTractions& boundary) const;
  BoundaryTractions solved_boundary_without_contact() const;

  /// Nodal forces of contact tractions on the dofs of the solved mesh [N/mm].
  VectorXd solved_forces(const ContactDensities& densities) const;

  /// Law and loads of a body on the solved mesh on the matched one.
  SolvedBody<2> matched(const SolvedBody<2>& solved) const;

  /// Values at the nodes of the solved line at those of the matched one [2 x p].
  Matrix2Xd nodal_values(const Matrix2Xd& solved) const;

  /// Vertex fields, one a column, linear in between.
  MatrixXd fields(const MatrixXd& solved) const;

  /// Edge tractions in equilibrium with the boundary's from those on the solved mesh.
  /// @param stress  that the latter balance, on the solved triangles
  EdgeMoments moments(const EdgeMoments& solved, const Matrix3Xd& stress,
                      const BoundaryTractions& boundary) const;

  /// Sums over the parts of the solved triangles.
  VectorXd sums_of_parts(const VectorXd& values) const;

  std::optional<CommonRefinement> take_refinement() {
    return std::move(refinement_);
  }

 private:
  struct Cut {
    Topology<2> topology;
    Flags prescribed;
    SolvedBody<2> body;
  };
  /// Moments on the solved boundary on that of the matched bodies.
  Matrix4Xd matched_moments(const Matrix4Xd& solved) const;
  /// Of the given and the springs' tractions.
  Matrix4Xd solved_moments() const;

  SolvedProblem<2> solved_;
  Matrix4Xd solved_springs_, springs_;
  std::optional<CommonRefinement> refinement_;
  std::optional<Cut> cut_;
};

/// Solids as they are solved: where surfaces do not match there is no common refinement, and
/// tractions have an oscillation (traction_oscillation).
template <>
class MatchedBodies<3> {
 public:
  /// @param solved  stays where it is
  explicit MatchedBodies(const SolvedProblem<3>& solved)
      : solved_(solved),
        springs_(spring_moments<3>(solved.topology.mesh, solved.body.springs,
                                   solved.body.displacement)) {}

  const Topology<3>& topology() const { return solved_.topology; }
  const ContactSurface& contact() const { return solved_.contact; }
  const SolvedBody<3>& body() const { return solved_.body; }
  const Flags& prescribed() const { return solved_.system.prescribed; }

  /// Moments of the springs' tractions [9 x boundary].
  FaceMoments& spring_tractions() { return springs_; }
  const FaceMoments& spring_tractions() const { return springs_; }
  void add_to_springs(const FaceMoments& change) { springs_ += change; }

  /// What the boundary carries with contact tractions at the nodes [MPa, 3 x p].
  FaceTractions boundary_with(const Ref<const Matrix3Xd>& nodal) const {
    const auto& [mesh, faces, ridges, stars] = topology();
    return with_contact(
        given_tractions<3>(mesh, faces, prescribed(),
                           with_springs<3>(body().neumann, springs_)),
        mesh, faces, contact(), nodal);
  }
  const FaceTractions& solved_boundary(const FaceTractions& boundary) const {
    return boundary;
  }
  FaceTractions solved_boundary_without_contact() const {
    return boundary_with(Matrix3Xd::Zero(3, contact().node_count()));
  }
  FaceMoments moments(FaceMoments solved, const CellStresses<3>&,
                      const FaceTractions&) const {
    return solved;
  }
  SolvedBody<3> matched(SolvedBody<3> solved) const { return solved; }
  MatrixXd fields(MatrixXd solved) const { return solved; }
  VectorXd sums_of_parts(VectorXd values) const { return values; }

 private:
  SolvedProblem<3> solved_;
  FaceMoments springs_;
};

}  // namespace ffcontact
