// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/cone/contact_relaxation.hpp"
#include "ffcontact/equilibrium/cone/contact_star.hpp"

namespace ffcontact {

/// Relaxes contact tractions inside the cone: one after the other, the stars of the ridges
/// of contact facets take what lowers e^2 most (ContactStar). Where facets of two bodies
/// match (ContactFacet::opposite) a star goes through both.
///
/// The order is that of ridge_groups, whatever the numbers of mesh and surface.
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
  double contact_part() const override;
  /// @param least_fall  what is nothing in a star
  double pass(double least_fall, FacetColumns<d>& corrections,
              FacetColumns<d>& residual) override;

 private:
  using Star = ContactStar<d>;

  void colour();
  typename Star::Scales scales(double least_fall) const;
  std::vector<typename Star::Change> changes(
      const std::vector<int>& colour, const typename Star::Scales& scales,
      const FacetColumns<d>& residual);
  void add(const RidgeGroup& group, const VectorXd& x,
           FacetColumns<d>& corrections, FacetColumns<d>& residual) const;

  const FacetTopology<d> topology_;
  const FacetForms<d>& forms_;
  const FreeContact<d> contact_;
  typename Star::Tractions tractions_;  ///< r_hat of the contact facets
  std::vector<Star> stars_;
  std::vector<std::vector<int>> colours_;  ///< the stars of each
  double stress_ = 0;  ///< the largest in the cells of contact facets [MPa]
};

}  // namespace ffcontact
