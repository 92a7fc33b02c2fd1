// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/equilibrium/cone/free_contact.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"

namespace ffcontact {

/// The corrections of the facets around the ridges of a group, those of contact tractions
/// among them: x of RidgeGroup, lowering
///     e^2 = e_0^2 + 2 g'x + x'A x + 2 sum of contact_term(r_hat + P x)
/// where r_hat + P x is in the cone at the vertices of the contact facets.
///
/// P leaves the modes of the facets inside the body out; these are eliminated. With x = N t
/// on the wrenches and the modes of the boundary facets, N the admissible corrections of
/// FreeContact,
///     S = N'(A_oo - A_oi A_ii^-1 A_io) N,   at most 12 x 12 for one or two bodies.
/// The change is to the unconstrained minimum if it is in the cone, or else to the minimum in
/// FacetCone.
template <int d>
class ContactStar {
 public:
  /// @param contact  stays where it is
  ContactStar(const FacetTopology<d>& topology, RidgeGroup group,
              const FreeContact<d>& contact, const FacetForms<d>& forms);

  /// Of corrections that need no basis, x = t.
  /// @param index      the contact facets that they change
  /// @param tractions  of each by x
  /// @param form       A
  ContactStar(const FreeContact<d>& contact, std::vector<int> index,
              std::vector<MatrixXd> tractions, MatrixXd form);

  const RidgeGroup& group() const { return group_; }
  /// Is there anything to change?
  bool is_free() const { return is_free_; }

  using Tractions = std::vector<MatrixOf<d>>;

  struct Scales {
    double least_fall;  ///< of e^2: less is nothing
    double traction;    ///< the largest around [MPa]
  };

  /// What lowers e^2 and keeps the cone.
  struct Change {
    VectorXd x;       ///< of the group
    double fall = 0;  ///< of e^2; 0: nothing does, no x
  };

  /// @param g           half the slope of the elastic part of e^2 by x
  /// @param tractions   r_hat at the vertices of all contact facets; those of the group
  ///                    are changed
  Change change(const VectorXd& g, const Scales& scales,
                Tractions& tractions) const;

 private:
  const ContactFacet<d>& facet(int k) const {
    return contact_->facets()[index_[k]];
  }
  void find_basis(const FacetTopology<d>& topology);
  void reduce(const MatrixXd& A);
  Tractions moved(const Tractions& from, const VectorXd& t) const;
  bool in_the_cone(const Tractions& tractions, double largest) const;
  double term(const Tractions& tractions) const;
  VectorXd slope_of_contact(const Tractions& from) const;
  VectorXd unknowns(const VectorXd& first, const VectorXd& t) const;
  std::optional<VectorXd> least(const VectorXd& slope, const Tractions& from,
                                const Scales& scales) const;
  std::optional<VectorXd> least_in_cones(const VectorXd& slope,
                                         const Tractions& from,
                                         double largest) const;

  RidgeGroup group_;
  const FreeContact<d>* contact_;
  std::vector<int> inside_, outside_;  ///< places in x
  std::vector<int> index_;   ///< of the contact facets around the ridges
  MatrixXd basis_;           ///< N
  std::vector<MatrixXd> P_;  ///< P N of each of them [d^2 x k]
  MatrixXd coupling_;        ///< A_io N
  MatrixXd S_;
  Cholesky A_inside_, S_factor_;
  bool is_free_ = false;
};

}  // namespace ffcontact
