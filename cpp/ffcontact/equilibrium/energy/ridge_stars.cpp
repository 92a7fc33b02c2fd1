// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/ridge_stars.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/energy/block_elimination.hpp"
#include "ffcontact/equilibrium/energy/short_edge_lines.hpp"
#include "ffcontact/equilibrium/energy/tiled_factor.hpp"
#include "ffcontact/linear/dense/congruent.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"

namespace ffcontact {

namespace {

template <int d>
RidgeLines lines_of(const FacetTopology<d>& topology, const FacetShare& share) {
  if constexpr (d == 2)
    return short_edge_lines(topology, share);
  else
    return single_ridges(share);
}

/// Conditions on the corrections of a ridge that depend on others but for this part.
constexpr PivotThreshold dependent_conditions{1e-9};

}  // namespace

template <int d>
MatrixXd RidgeStars<d>::form_of(int ridge, const FacetTractions<d>& boundary,
                                const FacetForms<d>& forms) {
  Star& star = stars_[ridge];
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
  return A;
}

/// basis_b' Z_b' H Z_a basis_a
template <int d>
MatrixXd RidgeStars<d>::coupling_of(int a, int b,
                                    const FacetForms<d>& forms) const {
  const int rows = stars_[b].size, columns = stars_[a].size;
  if (rows == 0 || columns == 0) return MatrixXd::Zero(rows, columns);
  const std::vector<int>& start = topology_.ridges.facet_start;
  MatrixXd A = coupling_form<d>(topology_, b, shifts_.data() + start[b], a,
                                shifts_.data() + start[a], forms);
  const MatrixXd &of_a = stars_[a].basis, &of_b = stars_[b].basis;
  if (of_a.size() > 0) A = (A * of_a).eval();
  if (of_b.size() > 0) A = (of_b.transpose() * A).eval();
  return A;
}

template <int d>
void RidgeStars<d>::factor_alone(int place, const FacetTractions<d>& boundary,
                                 const FacetForms<d>& forms) {
  const int ridge = lines_.ridge[place];
  MatrixXd A = form_of(ridge, boundary, forms);
  if (A.size() == 0) return;
  const Eigen::LLT<Ref<MatrixXd>> cholesky(A);  // in place
  if (cholesky.info() == Eigen::Success)
    put_tiles(A, factor_at(place));
  else
    stars_[ridge] = {};
}

template <int d>
void RidgeStars<d>::factor_line(int line, const FacetTractions<d>& boundary,
                                const FacetForms<d>& forms) {
  const int first = lines_.start[line], end = lines_.start[line + 1];
  if (end - first == 1) return factor_alone(first, boundary, forms);
  BlockElimination elimination(form_of(lines_.ridge[first], boundary, forms));
  for (int i = first; i < end; ++i) {
    if (i + 1 < end) {
      const MatrixXd next = form_of(lines_.ridge[i + 1], boundary, forms);
      elimination.append(
          next, coupling_of(lines_.ridge[i], lines_.ridge[i + 1], forms));
    }
    put_tiles(elimination.eliminated(), factor_at(i));
  }
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
      lines_(lines_of<d>(topology, share)),
      stars_(topology.ridges.count()) {
  place_facets();
  place_factors();
#pragma omp parallel for schedule(guided)
  for (int l = 0; l < lines_.count(); ++l) factor_line(l, boundary, forms);
}

template <int d>
double RidgeStars<d>::bytes(const FacetTopology<d>& topology) {
  const Ridges<d>& ridges = topology.ridges;
  double numbers = 0;
  for (int ridge = 0; ridge < ridges.count(); ++ridge)
    numbers +=
        static_cast<double>(factor_size(unknowns_around<d>(ridges, ridge)));
  return sizeof(float) * numbers +
         (sizeof(double) * Element::moments + sizeof(WrenchShift<d>)) * d *
             static_cast<double>(topology.facets.count());
}

template <int d>
void RidgeStars<d>::place_factors() {
  const auto unknowns = [&](int place) {
    return unknowns_around<d>(topology_.ridges, lines_.ridge[place]);
  };
  first_of_factor_ = {0};
  for (int l = 0; l < lines_.count(); ++l) {
    const int end = lines_.start[l + 1];
    int of_line = 0;
    for (int i = lines_.start[l]; i < end; ++i) {
      of_line += tiled(unknowns(i));
      first_of_factor_.push_back(
          first_of_factor_.back() +
          front_size(unknowns(i), i + 1 < end ? unknowns(i + 1) : 0));
    }
    largest_ = std::max(largest_, of_line);
  }
  factors_.reset(new float[first_of_factor_.back()]);
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

/// x = basis' Z' g
template <int d>
void RidgeStars<d>::restrict_to_free(int ridge, const FacetColumns<d>& g,
                                     double* x) const {
  const auto& [basis, size] = stars_[ridge];
  if (basis.size() == 0) {
    if (size > 0) restrict_to(ridge, g, x);
    return;
  }
  VectorXd all(basis.rows());
  restrict_to(ridge, g, all.data());
  Map<VectorXd>(x, size).noalias() = basis.transpose() * all;
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

/// The size of the next star in the line of one, or 0.
template <int d>
int RidgeStars<d>::below(int line, int place) const {
  return place + 1 < lines_.start[line + 1] ? size_at(place + 1) : 0;
}

/// parts_ of the facets around a ridge.
template <int d>
void RidgeStars<d>::put_parts(int ridge, const double* x) {
  if (stars_[ridge].size == 0) return;
  const std::vector<int>& start = topology_.ridges.facet_start;
  for (int j = start[ridge]; j < start[ridge + 1]; ++j)
    parts_.col(j) = of_facet(ridge, j, x);
}

/// parts_ of the stars of a line.
/// @param x  room for their unknowns, whole tiles of each
template <int d>
void RidgeStars<d>::solve_line(int line, const FacetColumns<d>& g, double* x) {
  const int first = lines_.start[line], end = lines_.start[line + 1];
  double* next = x;
  for (int i = first; i < end; ++i) {
    restrict_to_free(lines_.ridge[i], g, next);
    next += tiled(size_at(i));
  }
  next = x;
  for (int i = first; i < end; ++i) {
    eliminate_tiles(factor_at(i), size_at(i), below(line, i), next);
    next += tiled(size_at(i));
  }
  for (int i = end - 1; i >= first; --i) {
    next -= tiled(size_at(i));
    substitute_tiles(factor_at(i), size_at(i), below(line, i), next);
    put_parts(lines_.ridge[i], next);
  }
}

template <int d>
void RidgeStars<d>::operator()(const FacetColumns<d>& g, FacetColumns<d>& z) {
#pragma omp parallel
  {
    VectorXd x = VectorXd::Zero(largest_);
#pragma omp for schedule(guided)
    for (int l = 0; l < lines_.count(); ++l) solve_line(l, g, x.data());
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
