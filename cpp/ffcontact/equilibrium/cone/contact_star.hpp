// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/equilibrium/cone/joint_edge.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"

namespace ffcontact {

/// The corrections of the faces around an edge of the contact surface, those of contact
/// tractions among them: x = (w, y_1, .., y_M) of a JointEdge, lowering
///     e^2 = e_0^2 + 2 g'x + x'A x + 2 sum of contact_term(r_hat + P x)
/// where r_hat + P x is in the cone at the vertices of the contact faces.
///
/// P leaves the modes of the faces inside the body out; these are eliminated. With x = N t
/// on the wrench and the modes of the boundary faces, N what leaves other known
/// tractions alone and r_t = 0 where there is no friction,
///     S = N'(A_oo - A_oi A_ii^-1 A_io) N,   at most 12 x 12 for one or two bodies.
/// The unconstrained minimum if it is in the cone, or else that in the inner cones.
class ContactStar {
 public:
  /// @param known          components of boundary tractions that stay, none of contact
  ///                       faces
  /// @param contact        stays where it is
  /// @param contact_index  of the contact face of each mesh face, or -1
  ContactStar(const Topology<3>& topology, JointEdge joint,
              const KnownComponents& known, const FacetForms<3>& forms,
              const std::vector<ContactFace>& contact,
              const std::vector<int>& contact_index);

  const JointEdge& joint() const { return joint_; }
  /// Is there anything that changes contact tractions?
  bool is_free() const { return basis_.cols() > 0; }

  struct Scales {
    double least_fall;  ///< of e^2: less is nothing
    double traction;    ///< largest on the surface [MPa]
  };

  /// What lowers e^2 and keeps the cone.
  struct Change {
    VectorXd x;       ///< [6 + 3 M]
    double fall = 0;  ///< of e^2; 0: nothing does, no x
  };

  /// @param g           half the slope of the elastic part of e^2 by x
  /// @param tractions   r_hat at the vertices of all contact faces; those of the edge are
  ///                    changed
  Change change(const VectorXd& g, const Scales& scales,
                std::vector<Matrix3d>& tractions) const;

 private:
  using Tractions = std::vector<Matrix3d>;

  void find_places(const Topology<3>& topology);
  void find_basis(const Topology<3>& topology, const KnownComponents& known,
                  const std::vector<ContactFace>& contact,
                  const std::vector<int>& contact_index);
  void reduce(const MatrixXd& A);
  VectorXd solve_inside(const VectorXd& b) const;
  Tractions moved(const Tractions& from, const VectorXd& t) const;
  bool in_the_cone(const Tractions& tractions, double largest) const;
  double term(const Tractions& tractions) const;
  std::optional<VectorXd> least(const VectorXd& slope, const Tractions& from,
                                const Scales& scales) const;
  std::optional<VectorXd> least_in_cones(const VectorXd& slope,
                                         const Tractions& from,
                                         double largest) const;

  JointEdge joint_;
  std::vector<int> inside_, outside_;      ///< places in x
  std::vector<const ContactFace*> faces_;  ///< the contact faces of the edge,
  std::vector<int> index_;                 ///< their indices
  MatrixXd basis_;                         ///< N
  std::vector<MatrixXd> P_;                ///< P N of each of them [9 x k]
  MatrixXd coupling_;                      ///< A_io N
  MatrixXd S_;
  Cholesky A_inside_, S_factor_;
};

}  // namespace ffcontact
