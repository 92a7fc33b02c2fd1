// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/cone/ridge_group.hpp"
#include "ffcontact/equilibrium/tractions/facet_setting.hpp"

namespace ffcontact {

/// The contact facets of a setting and what stays as it is around them.
template <int d>
class FreeContact {
 public:
  /// @param setting  what it refers to stays where it is
  explicit FreeContact(const FacetSetting<d>& setting);

  const std::vector<ContactFacet<d>>& facets() const { return facets_; }
  /// The contact facet that a facet of the mesh is, or -1; those that face several facets of
  /// another body count as known boundary.
  int index_of(int facet) const { return index_[facet]; }

  /// Basis of the corrections of a group that leave known boundary tractions alone, r_t
  /// where friction may vanish and the kept work of r_hat, and load both bodies of a
  /// contact facet oppositely; one a column.
  /// @param spokes  by the unknowns that the basis is of
  MatrixXd admissible_corrections(
      const std::vector<BoundarySpoke<d>>& spokes) const;

 private:
  class Conditions;

  void fix_known(const BoundarySpoke<d>& spoke, Conditions& conditions) const;
  void keep_law(const ContactFacet<d>& facet, const BoundarySpoke<d>& own,
                const std::vector<BoundarySpoke<d>>& spokes,
                Conditions& conditions) const;
  Eigen::RowVectorXd work_row(const BoundarySpoke<d>& spoke,
                              const Ref<const VectorXd>& z) const;
  void keep_work(const std::vector<BoundarySpoke<d>>& spokes,
                 const Ref<const VectorXd>& z, Conditions& conditions) const;

  const Facets<d>& mesh_facets_;
  const FacetTractions<d>& boundary_;
  const std::vector<ContactFacet<d>>& facets_;
  const MatrixXd& kept_work_;
  KnownTractions<d> known_;
  std::vector<int> index_;
};

}  // namespace ffcontact
