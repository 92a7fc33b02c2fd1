// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/contact_star.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/over.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/cone/facet_cone.hpp"
#include "ffcontact/linear/minimum/quadratic_minimum.hpp"

namespace ffcontact {

namespace {

/// Tractions outside the cone by this part of the largest are in it but for rounding,
/// which is taken off at the end. Less, and the digits of sums say which stars stay.
constexpr double cone_rounding = 1e-12;

/// Conditions on tractions that corrections change by less than this part of what they
/// could are not changed by them.
constexpr double least_change = 1e-12;

/// Half the slope of the contact part of e^2 by the tractions at the vertices.
template <int d>
MatrixOf<d> contact_slope(const ContactFacet<d>& facet,
                          const MatrixOf<d>& traction) {
  MatrixOf<d> slope = facet.work;
  for (int i = 0; i < d; ++i)
    if (!facet.paid[i].at_limit(traction(0, i)))
      slope(0, i) -= facet.paid[i].friction * facet.slip[i];
  return slope;
}

/// Conditions C t >= least on the corrections of tractions.
struct ConesOfCorrections {
  MatrixXd C;
  VectorXd least;
  Index rows = 0;

  explicit ConesOfCorrections(Index unknowns) : C(0, unknowns) {}

  /// @param P  tractions of a facet by t
  template <int d>
  void add(const FacetCone<d>& cone, const MatrixXd& P,
           const MatrixOf<d>& from) {
    const MatrixXd changes = cone.C * P;
    const double size = P.norm();
    C.conservativeResize(rows + changes.rows(), Eigen::NoChange);
    least.conservativeResize(rows + changes.rows());
    for (Index row = 0; row < changes.rows(); ++row) {
      if (changes.row(row).norm() <=
          least_change * size * cone.C.row(row).norm())
        continue;
      C.row(rows) = changes.row(row);
      least[rows++] = cone.least[row] - cone.C.row(row).dot(from.reshaped());
    }
  }
};

}  // namespace

template <int d>
ContactStar<d>::ContactStar(const FacetTopology<d>& topology, RidgeGroup group,
                            const FreeContact<d>& contact,
                            const FacetForms<d>& forms)
    : group_(std::move(group)),
      contact_(&contact),
      outside_(unknowns_on_boundary<d>(topology, group_)) {
  for (int i = 0; i < group_.unknowns(); ++i)
    if (!std::binary_search(outside_.begin(), outside_.end(), i))
      inside_.push_back(i);
  find_basis(topology);
  reduce(group_form<d>(topology, group_, forms));
}

template <int d>
ContactStar<d>::ContactStar(const FreeContact<d>& contact,
                            std::vector<int> index,
                            std::vector<MatrixXd> tractions, MatrixXd form)
    : group_{{}, {static_cast<int>(form.rows())}},
      contact_(&contact),
      index_(std::move(index)),
      basis_(MatrixXd::Identity(form.rows(), form.rows())),
      P_(std::move(tractions)) {
  for (int i = 0; i < form.rows(); ++i) outside_.push_back(i);
  reduce(form);
}

template <int d>
void ContactStar<d>::find_basis(const FacetTopology<d>& topology) {
  std::vector<BoundarySpoke<d>> spokes = boundary_spokes<d>(topology, group_);
  for (BoundarySpoke<d>& spoke : spokes)
    spoke.moments = spoke.moments(Eigen::all, outside_).eval();
  basis_ = contact_->admissible_corrections(spokes);
  for (const BoundarySpoke<d>& spoke : spokes) {
    const int index = contact_->index_of(spoke.facet);
    if (index < 0) continue;
    index_.push_back(index);
    P_.push_back(tractions_of_columns<d>(contact_->facets()[index],
                                         spoke.moments * basis_));
  }
}

template <int d>
void ContactStar<d>::reduce(const MatrixXd& A) {
  A_inside_ = Cholesky(A(inside_, inside_));
  coupling_ = A(inside_, outside_) * basis_;
  S_ = basis_.transpose() * A(outside_, outside_) * basis_ -
       coupling_.transpose() * A_inside_.solve_columns(coupling_);
  S_factor_ = Cholesky(S_);
  is_free_ = basis_.cols() + count_of(inside_) > 0 &&
             A_inside_.is_positive_definite() &&
             S_factor_.is_positive_definite();
}

template <int d>
typename ContactStar<d>::Tractions ContactStar<d>::moved(
    const Tractions& from, const VectorXd& t) const {
  Tractions to = from;
  for (std::size_t k = 0; k < to.size(); ++k)
    to[k] += (P_[k] * t).reshaped(d, d);
  return to;
}

template <int d>
bool ContactStar<d>::in_the_cone(const Tractions& tractions,
                                 double largest) const {
  for (int k = 0; k < count_of(tractions); ++k)
    if (cone_violation<d>(facet(k), tractions[k]) > cone_rounding * largest)
      return false;
  return true;
}

template <int d>
double ContactStar<d>::term(const Tractions& tractions) const {
  return sum_over(tractions.size(), [&](int k) {
    return contact_term<d>(facet(k), tractions[k]);
  });
}

/// t with the least t'S t / 2 + slope't in the cones.
template <int d>
std::optional<VectorXd> ContactStar<d>::least_in_cones(const VectorXd& slope,
                                                       const Tractions& from,
                                                       double largest) const {
  ConesOfCorrections cones(slope.size());
  for (int k = 0; k < count_of(from); ++k)
    cones.add<d>(facet_cone<d>(facet(k), from[k], largest), P_[k], from[k]);
  const auto t = quadratic_minimum(S_, slope, cones.C.topRows(cones.rows),
                                   cones.least.head(cones.rows));
  return t && in_the_cone(moved(from, *t), largest) ? t : std::nullopt;
}

template <int d>
std::optional<VectorXd> ContactStar<d>::least(const VectorXd& slope,
                                              const Tractions& from,
                                              const Scales& scales) const {
  if (slope.size() == 0) return slope;  // modes inside alone
  const VectorXd t = -S_factor_.solve(slope);
  if (-slope.dot(t) <= scales.least_fall) return std::nullopt;
  return in_the_cone(moved(from, t), scales.traction)
             ? t
             : least_in_cones(slope, from, scales.traction);
}

/// Half the slope of the contact part of e^2 by t.
template <int d>
VectorXd ContactStar<d>::slope_of_contact(const Tractions& from) const {
  VectorXd slope = VectorXd::Zero(basis_.cols());
  for (int k = 0; k < count_of(from); ++k)
    slope += P_[k].transpose() * contact_slope<d>(facet(k), from[k]).reshaped();
  return slope;
}

/// @param first  modes inside for t = 0
template <int d>
VectorXd ContactStar<d>::unknowns(const VectorXd& first,
                                  const VectorXd& t) const {
  VectorXd x(group_.unknowns());
  x(outside_) = basis_ * t;
  x(inside_) = first - A_inside_.solve(coupling_ * t);
  return x;
}

template <int d>
typename ContactStar<d>::Change ContactStar<d>::change(
    const VectorXd& g, const Scales& scales, Tractions& tractions) const {
  if (!is_free_) return {};
  const VectorXd g_inside = g(inside_), first = -A_inside_.solve(g_inside),
                 elastic = basis_.transpose() * g(outside_) +
                           coupling_.transpose() * first;
  Tractions from;
  for (int m : index_) from.push_back(tractions[m]);
  const std::optional<VectorXd> t =
      least(elastic + slope_of_contact(from), from, scales);
  if (!t) return {};
  const Tractions to = moved(from, *t);
  const double fall = -g_inside.dot(first) - t->dot(2 * elastic + S_ * *t) -
                      2 * (term(to) - term(from));
  if (!(fall > scales.least_fall)) return {};
  for (int k = 0; k < count_of(index_); ++k) tractions[index_[k]] = to[k];
  return {unknowns(first, *t), fall};
}

template class ContactStar<FFCONTACT_DIMENSION>;

}  // namespace ffcontact
