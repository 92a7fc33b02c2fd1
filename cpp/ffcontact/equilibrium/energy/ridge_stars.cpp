// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/ridge_stars.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/energy/tiled_factor.hpp"
#include "ffcontact/linear/dense/congruent.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"

namespace ffcontact {

namespace {

/// Conditions on the corrections of a ridge that depend on others but for this part.
constexpr PivotThreshold dependent_conditions{1e-9};

}  // namespace

template <int d>
typename RidgeStars<d>::Star RidgeStars<d>::star(
    int ridge, const FacetTractions<d>& boundary, const FacetForms<d>& forms,
    float* factor) const {
  Star star;
  const WrenchShift<d>* shifts =
      shifts_.data() + topology_.ridges.facet_start[ridge];
  MatrixXd A = ridge_form<d>(topology_, ridge, shifts, forms);
  if (topology_.ridges.on_boundary[ridge]) {
    const MatrixXd known = ridge_conditions<d>(
        topology_, ridge, shifts, boundary.known, boundary.known_direction);
    if (known.rows() > 0) {
      const MatrixXd basis = kernel_basis(known, dependent_conditions);
      A = congruent(A, basis);
      star.basis = basis;
    }
  }
  star.size = static_cast<int>(A.rows());
  if (star.size == 0) return star;
  const Eigen::LLT<Ref<MatrixXd>> cholesky(A);  // in place
  if (cholesky.info() == Eigen::Success)
    put_tiles(A, factor);
  else
    star = {MatrixXd(), 0};
  return star;
}

template <int d>
RidgeStars<d>::RidgeStars(const FacetTopology<d>& topology,
                          const FacetShare& share,
                          const FacetTractions<d>& boundary,
                          const FacetForms<d>& forms)
    : topology_(topology),
      share_(share),
      place_(d, topology.facets.count()),
      shifts_(topology.ridges.facet.size()),
      parts_(FacetColumns<d>::Zero(Element::moments,
                                   count_of(topology.ridges.facet))),
      stars_(topology.ridges.count()),
      first_of_factor_(1, 0) {
  const Ridges<d>& ridges = topology.ridges;
  for (int e = 0; e < ridges.count(); ++e) {
    const int size = share.ridge[e] ? unknowns_around<d>(ridges, e) : 0;
    largest_ = std::max(largest_, tiled(size));
    first_of_factor_.push_back(first_of_factor_.back() + factor_size(size));
  }
  factors_.reset(new float[first_of_factor_.back()]);
  place_facets();
#pragma omp parallel for
  for (int e = 0; e < ridges.count(); ++e)
    if (share.ridge[e])
      stars_[e] =
          star(e, boundary, forms, factors_.get() + first_of_factor_[e]);
}

template <int d>
void RidgeStars<d>::place_facets() {
  const Ridges<d>& ridges = topology_.ridges;
#pragma omp parallel for
  for (int e = 0; e < ridges.count(); ++e)
    for (int i = ridges.facet_start[e]; i < ridges.facet_start[e + 1]; ++i) {
      const int facet = ridges.facet[i];
      shifts_[i] = wrench_shift<d>(topology_, facet, e);
      for (int k = 0; k < d; ++k)
        if (ridges.of_facet(k, facet) == e) place_(k, facet) = i;
    }
}

/// x = Z' g
template <int d>
void RidgeStars<d>::restrict_to(int ridge, const FacetColumns<d>& g,
                                double* x) const {
  const Ridges<d>& ridges = topology_.ridges;
  Wrench<d> sum = Wrench<d>::Zero();
  double* of_modes = x + wrench;
  for (int i = ridges.facet_start[ridge]; i < ridges.facet_start[ridge + 1];
       ++i, of_modes += modes) {
    const auto of_facet = g.col(ridges.facet[i]);
    sum += shifts_[i].transposed_times(of_facet.template head<wrench>());
    Map<Matrix<double, modes, 1>>{of_modes} = of_facet.template tail<modes>();
  }
  Map<Wrench<d>>{x} = sum;
}

/// x <- A^-1 basis' x
template <int d>
void RidgeStars<d>::solve(int ridge, double* x) const {
  const auto& [basis, size] = stars_[ridge];
  if (basis.size() > 0) {
    Map<VectorXd> all(x, unknowns_around<d>(topology_.ridges, ridge));
    const VectorXd inside = basis.transpose() * all;
    all.head(size) = inside;
  }
  solve_tiles(factors_.get() + first_of_factor_[ridge], size, x);
}

/// What a ridge has for one of its facets: Z basis x.
template <int d>
FacetVector<d> RidgeStars<d>::of_facet(int ridge, int facet,
                                       const double* x) const {
  const auto& [basis, size] = stars_[ridge];
  const int first =
      wrench + modes * (facet - topology_.ridges.facet_start[ridge]);
  Wrench<d> w;
  Matrix<double, modes, 1> y;
  if (basis.size() > 0) {
    const Map<const VectorXd> inside(x, size);
    w = basis.template topRows<wrench>() * inside;
    y = basis.template middleRows<modes>(first) * inside;
  } else {
    w = Map<const Wrench<d>>(x);
    y = Map<const Matrix<double, modes, 1>>(x + first);
  }
  FacetVector<d> unknowns;
  unknowns << shifts_[facet].times(w), y;
  return unknowns;
}

template <int d>
void RidgeStars<d>::operator()(const FacetColumns<d>& g, FacetColumns<d>& z) {
  const std::vector<int>& start = topology_.ridges.facet_start;
#pragma omp parallel
  {
    VectorXd x = VectorXd::Zero(largest_);
#pragma omp for
    for (int e = 0; e < topology_.ridges.count(); ++e) {
      if (stars_[e].size == 0) continue;
      restrict_to(e, g, x.data());
      solve(e, x.data());
      for (int i = start[e]; i < start[e + 1]; ++i)
        parts_.col(i) = of_facet(e, i, x.data());
    }
#pragma omp for
    for (int f = 0; f < topology_.facets.count(); ++f) {
      FacetVector<d> sum = FacetVector<d>::Zero();
      if (share_.facet[f]) {
        sum = parts_.col(place_(0, f));
        for (int k = 1; k < d; ++k) sum += parts_.col(place_(k, f));
      }
      z.col(f) = sum;
    }
  }
}

template class RidgeStars<FFCONTACT_DIMENSION>;

}  // namespace ffcontact
