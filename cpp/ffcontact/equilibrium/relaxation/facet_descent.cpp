// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/relaxation/facet_descent.hpp"

#include <Eigen/LU>
#include <cmath>

#include "ffcontact/base/parted_sum.hpp"

namespace ffcontact {

template <int d>
FacetDescent<d>::FacetDescent(const LoadedFacets<d>& body,
                              const FacetColumns<d>& moments,
                              const FacetShare& share,
                              const FacetExchange<d>& exchange)
    : body_(body),
      share_(share),
      exchange_(exchange),
      forms_(body.topology, body.hooke, body.terms),
      stars_(body.topology, share, body.boundary, forms_),
      corrections_(FacetColumns<d>::Zero(Element::moments, moments.cols())),
      residual_(Element::moments, moments.cols()),
      direction_(Element::moments, moments.cols()),
      next_(Element::moments, moments.cols()),
      images_(Element::loads, body.topology.mesh.cell_count()),
      image_(Element::moments, moments.cols()) {
  const FacetTopology<d>& topology = body.topology;
  const int cells = topology.mesh.cell_count();
  VectorXd squares = VectorXd::Zero(cells);
#pragma omp parallel for
  for (int t = 0; t < cells; ++t) {
    if (!share.cell[t]) continue;
    const CellCorners<d> corners = topology.corners(t);
    const VoigtMatrix<d> compliance = body.hooke[t].inverse();
    const SubcellStress<d> tau = difference_stress(body, moments, t);
    squares[t] = energy(corners, compliance, tau);
    images_.col(t) =
        -facet_slope<d>(corners, compliance, tau, wrench_bases<d>(topology, t));
  }
  of_share_ = parted_sum(cells, [&](int t) { return squares[t]; });
}

template <int d>
double FacetDescent<d>::bytes(const FacetTopology<d>& topology) {
  constexpr int columns_of_facets = 5;
  const double cells = topology.mesh.cell_count(),
               facets = topology.facets.count();
  return static_cast<double>(sizeof(typename FacetForms<d>::Stored)) *
             FacetForms<d>::stored * cells +
         RidgeStars<d>::bytes(topology) +
         sizeof(double) * (Element::loads * cells +
                           columns_of_facets * Element::moments * facets);
}

template <int d>
double FacetDescent<d>::begin() {
  exchange_.complete(images_);
  gather(residual_);
  double of_terms = 0;
  for (const FacetTerm<d>& term : body_.terms) {
    residual_.col(term.facet) -= slope_of<d>(body_.topology, term);
    of_terms += term.before;
  }
  return exchange_.sum(of_share_ + of_terms);
}

/// y = sum of what the cells beside each facet have for it in images_.
template <int d>
void FacetDescent<d>::gather(FacetColumns<d>& y) const {
  constexpr int size = Element::moments;
  const Facets<d>& facets = body_.topology.facets;
#pragma omp parallel for
  for (int f = 0; f < facets.count(); ++f) {
    FacetVector<d> sum = FacetVector<d>::Zero();
    for (int t : facets.cells.col(f))
      if (t >= 0)
        sum += images_.col(t).template segment<size>(size *
                                                     facets.side_of_cell(f, t));
    y.col(f) = sum;
  }
}

template <int d>
double FacetDescent<d>::dot(const FacetColumns<d>& a,
                            const FacetColumns<d>& b) const {
  return exchange_.sum(parted_sum(static_cast<int>(a.cols()), [&](int f) {
    return share_.counted[f] ? a.col(f).dot(b.col(f)) : 0;
  }));
}

template <int d>
void FacetDescent<d>::add(double factor, const FacetColumns<d>& y,
                          FacetColumns<d>& x) const {
#pragma omp parallel for
  for (Index f = 0; f < x.cols(); ++f) x.col(f) += factor * y.col(f);
}

/// z - (z'Hp / p'Hp) p; false where too much of it would be rounding.
template <int d>
bool FacetDescent<d>::find_conjugate() {
  constexpr double most = 1e4;  // times the rounding of p itself
  if (!(square_ > 0)) return false;
  stars_(residual_, next_);
  const double factor = -dot(next_, image_) / square_,
               before = std::sqrt(dot(next_, next_));
  add(factor, direction_, next_);
  rounding_ = before + std::abs(factor) * rounding_;
  return rounding_ <= most * std::sqrt(dot(next_, next_));
}

/// z alone.
template <int d>
void FacetDescent<d>::find_steepest() {
  stars_(residual_, next_);
  rounding_ = std::sqrt(dot(next_, next_));
}

template <int d>
bool FacetDescent<d>::turn_direction() {
  if (!find_conjugate()) find_steepest();
  direction_.swap(next_);

  const FacetTopology<d>& topology = body_.topology;
#pragma omp parallel for
  for (int t = 0; t < topology.mesh.cell_count(); ++t)
    if (share_.cell[t])
      images_.col(t) =
          forms_.times(t, unknowns_at<d>(topology.facets, direction_, t));
  exchange_.complete(images_);
  gather(image_);
  square_ = dot(direction_, image_);
  return square_ > 0;
}

template <int d>
double FacetDescent<d>::step() {
  if (!turn_direction()) return 0;
  const double slope = dot(residual_, direction_), length = slope / square_;
  add(length, direction_, corrections_);
  add(-length, image_, residual_);
  return length * slope;
}

template <int d>
void add_corrections(const FacetTopology<d>& topology,
                     const KnownTractions<d>& known,
                     const FacetColumns<d>& corrections,
                     FacetColumns<d>& moments) {
#pragma omp parallel for
  for (int f = 0; f < topology.facets.count(); ++f) {
    const FacetVector<d> added =
        wrench_basis<d>(topology.facet_corners(f)) * corrections.col(f);
    for (int row = 0; row < added.size(); ++row)
      if (!known(row % d, f)) moments(row, f) += added[row];
  }
}

template class FacetDescent<FFCONTACT_DIMENSION>;
template void add_corrections(const FacetTopology<FFCONTACT_DIMENSION>&,
                              const KnownTractions<FFCONTACT_DIMENSION>&,
                              const FacetColumns<FFCONTACT_DIMENSION>&,
                              FacetColumns<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
