// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/free_contact.hpp"

#include <algorithm>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"

namespace ffcontact {

namespace {

/// A condition that corrections change by less than this part of what they could is not
/// changed by them. In the plane coordinates far from the origin are known to little more,
/// but stresses whose conditions are left out by this are out of equilibrium by a hundred
/// times it. Faces that match are the same to 1e-11 (matching_faces), and what is less says
/// the same twice.
template <int d>
constexpr double negligible_change = d > 2 ? 1e-9 : 1e-12;

/// Without those that face several facets.
template <int d>
std::vector<ContactFacet<d>> matching(std::vector<ContactFacet<d>> facets) {
  const auto faces_several = [](const ContactFacet<d>& facet) {
    return !facet.facing.empty();
  };
  facets.erase(std::remove_if(facets.begin(), facets.end(), faces_several),
               facets.end());
  return facets;
}

}  // namespace

/// Homogeneous linear conditions on corrections.
template <int d>
class FreeContact<d>::Conditions {
 public:
  explicit Conditions(Index unknowns) : rows_(0, unknowns) {}

  void add(const Ref<const MatrixXd>& rows) {
    rows_.conservativeResize(rows_.rows() + rows.rows(), Eigen::NoChange);
    rows_.bottomRows(rows.rows()) = rows;
  }
  MatrixXd kernel() const {
    if (rows_.rows() == 0)
      return MatrixXd::Identity(rows_.cols(), rows_.cols());
    return kernel_basis(rows_, {negligible_change<d>});
  }

 private:
  MatrixXd rows_;
};

template <int d>
FreeContact<d>::FreeContact(const FacetSetting<d>& setting)
    : mesh_facets_(setting.body.topology.facets),
      boundary_(setting.body.boundary),
      facets_(setting.contact),
      kept_work_(setting.kept_work),
      known_(without_contact<d>(boundary_.known, matching<d>(facets_))),
      index_(mesh_facets_.count(), -1) {
  for (int m = 0; m < count_of(facets_); ++m)
    if (facets_[m].facing.empty()) index_[facets_[m].facet] = m;
}

template <int d>
void FreeContact<d>::fix_known(const BoundarySpoke<d>& spoke,
                               Conditions& conditions) const {
  for (int row = 0; row < spoke.moments.rows(); ++row)
    if (known_(row % d, spoke.facet)) conditions.add(spoke.moments.row(row));
  const auto own = boundary_.known_direction.find(spoke.facet);
  if (own == boundary_.known_direction.end()) return;
  for (int j = 0; j < d; ++j)
    conditions.add(own->second.transpose() *
                   spoke.moments.template middleRows<d>(d * j));
}

namespace {

/// r_t stays where friction may vanish, as a moment.
template <int d>
MatrixXd frictionless_rows(const ContactFacet<d>& facet,
                           const BoundarySpoke<d>& spoke) {
  const MatrixXd tractions = tractions_of_columns<d>(facet, spoke.moments);
  MatrixXd rows(d * (d - 1), tractions.cols());
  Index count = 0;
  for (int i = 0; i < d; ++i)
    if (facet.cone[i].frictionless()) {
      rows.middleRows<d - 1>(count) = facet.measure / (d * (d + 1)) *
                                      tractions.middleRows<d - 1>(d * i + 1);
      count += d - 1;
    }
  return rows.topRows(count);
}

/// The sum of the moments that a contact facet and the one that it faces feel, at each corner.
template <int d>
MatrixXd opposition_rows(const ContactFacet<d>& facet,
                         const BoundarySpoke<d>& own,
                         const BoundarySpoke<d>& opposite) {
  MatrixXd rows = own.moments;
  for (int k = 0; k < d; ++k)
    rows.middleRows<d>(d * k) +=
        opposite.moments.template middleRows<d>(d * facet.opposite_corner[k]);
  return rows;
}

}  // namespace

/// int r_hat . z on a contact facet by the corrections.
template <int d>
Eigen::RowVectorXd FreeContact<d>::work_row(
    const BoundarySpoke<d>& spoke, const Ref<const VectorXd>& z) const {
  FacetVector<d> at_corners;
  for (int k = 0; k < d; ++k)
    at_corners.template segment<d>(d * k) =
        z.segment<d>(d * mesh_facets_.vertices(k, spoke.facet));
  return at_corners.transpose() * spoke.moments;
}

/// int r_hat . z does not change. But where a support takes part it does not anyway, as
/// self-equilibrated corrections have no resultant.
template <int d>
void FreeContact<d>::keep_work(const std::vector<BoundarySpoke<d>>& spokes,
                               const Ref<const VectorXd>& z,
                               Conditions& conditions) const {
  Eigen::RowVectorXd work =
      Eigen::RowVectorXd::Zero(spokes.front().moments.cols());
  double terms = 0;
  for (const BoundarySpoke<d>& spoke : spokes) {
    if (index_of(spoke.facet) < 0) continue;
    const Eigen::RowVectorXd of_spoke = work_row(spoke, z);
    terms += of_spoke.norm();
    work += of_spoke;
  }
  if (work.norm() > negligible_change<d> * terms) conditions.add(work);
}

/// The conditions on a contact facet: its law, and opposite tractions on the one it faces.
template <int d>
void FreeContact<d>::keep_law(const ContactFacet<d>& facet,
                              const BoundarySpoke<d>& own,
                              const std::vector<BoundarySpoke<d>>& spokes,
                              Conditions& conditions) const {
  conditions.add(frictionless_rows<d>(facet, own));
  for (const BoundarySpoke<d>& other : spokes)
    if (other.facet == facet.opposite)
      conditions.add(opposition_rows<d>(facet, own, other));
}

template <int d>
MatrixXd FreeContact<d>::admissible_corrections(
    const std::vector<BoundarySpoke<d>>& spokes) const {
  Conditions conditions(spokes.front().moments.cols());
  for (const BoundarySpoke<d>& spoke : spokes) {
    const int index = index_of(spoke.facet);
    if (index < 0)
      fix_known(spoke, conditions);
    else
      keep_law(facets_[index], spoke, spokes, conditions);
  }
  for (Index k = 0; k < kept_work_.cols(); ++k)
    keep_work(spokes, kept_work_.col(k), conditions);
  return conditions.kernel();
}

template class FreeContact<FFCONTACT_DIMENSION>;

}  // namespace ffcontact
