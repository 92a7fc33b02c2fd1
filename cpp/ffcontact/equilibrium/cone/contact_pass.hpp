// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "ffcontact/equilibrium/cone/contact_relaxation.hpp"
#include "ffcontact/equilibrium/cone/contact_star.hpp"
#include "ffcontact/equilibrium/cone/facing_star.hpp"

namespace ffcontact {

/// Relaxes contact tractions inside the cone: one after the other, the stars of the ridges
/// of contact facets take what lowers e^2 most (ContactStar). Where facets of two bodies
/// match (ContactFacet::opposite) a star goes through both, and where they do not it goes through
/// all that its contact facets face (FacingStar).
///
/// There e + o is the bound, o^2 the sum of FacingOscillation, and a star lowers
///     e^2 + (e / o)^2 o^2,
/// for which parts that e and o fall by count alike. (e / o)^2 is a guess from the first
/// fields, of which relaxation divides e by some 4, and at most 4.
///
/// The order is that of ridge_groups, whatever the numbers of mesh and surface, and then that
/// of facing_stars.
/// Stars that have no cell in common are of one colour and change together: the digits do
/// not depend on the number of threads.
template <int d>
class ContactPass : public ContactRelaxation<d> {
 public:
  /// @param setting  stays where it is; without contact facets a pass does nothing
  /// @param moments  of all facets, from which r_hat is taken
  ContactPass(const FacetSetting<d>& setting, const FacetForms<d>& forms,
              const FacetColumns<d>& moments);
  ContactPass(const ContactPass&) = delete;

  bool is_free() const override { return !contact_.facets().empty(); }
  void weigh(double first_square) override;
  double contact_part() const override;
  /// @param least_fall  what is nothing in a star
  double pass(double least_fall, FacetColumns<d>& corrections,
              FacetColumns<d>& residual) override;

 private:
  using Star = ContactStar<d>;

  void add_facing_stars();
  double oscillation() const;
  MatrixXd form_of_oscillation(const FacingStar<d>& star) const;
  std::vector<int> cells_of(int star) const;
  VectorXd slope_of(int star, const FacetColumns<d>& residual) const;
  void colour();
  typename Star::Scales scales(double least_fall) const;
  std::vector<typename Star::Change> changes(
      const std::vector<int>& colour, const typename Star::Scales& scales,
      const FacetColumns<d>& residual);
  void add(int star, const VectorXd& x, FacetColumns<d>& corrections,
           FacetColumns<d>& residual) const;
  int group_count() const { return count_of(stars_) - count_of(facing_); }

  const FacetTopology<d> topology_;
  const FacetForms<d>& forms_;
  const FreeContact<d> contact_;
  typename Star::Tractions tractions_;  ///< r_hat of the contact facets
  const std::vector<FacingOscillation<d>>& oscillation_;
  /// those that a contact facet has a part in, and which part it is
  std::vector<std::vector<std::pair<int, int>>> oscillation_of_;
  std::vector<Star> stars_;  ///< of ridge groups, and then of facing_
  std::vector<FacingStar<d>> facing_;
  /// of each of these, of e^2 and of o^2 by its corrections
  std::vector<MatrixXd> elastic_, beyond_;
  double weight_ = 1;                      ///< of o^2
  std::vector<std::vector<int>> colours_;  ///< the stars of each
  double stress_ = 0;  ///< the largest in the cells of contact facets [MPa]
};

}  // namespace ffcontact
