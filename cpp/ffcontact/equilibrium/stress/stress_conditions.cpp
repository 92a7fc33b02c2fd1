// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/stress_conditions.hpp"

#include <array>
#include <cmath>

#include "ffcontact/equilibrium/stress/facet_density.hpp"

namespace ffcontact {

namespace {

template <int d>
struct Sizes : CompositeElement<d> {
  static constexpr int coefficients =
                           voigt_size<d> * CompositeElement<d>::values,
                       jumps = InnerJumps<d>::SizeAtCompileTime;
  static constexpr int before_loads = CompositeElement<d>::body_loads + jumps;
};

/// f on subcell k from the moments int f phi_i: with n = d + 1 corners the mean of phi_i
/// over subcell k is 1 / n^2 for i = k and (n + 1) / n^2 otherwise.
template <int d>
Matrix<double, d + 1, d + 1> force_per_body_load(double volume) {
  constexpr double n = d + 1;
  Matrix<double, d + 1, d + 1> means;
  means.setConstant((n + 1) / (n * n));
  means.diagonal().setConstant(1 / (n * n));
  return (volume / n * means).inverse();
}

/// An inner facet: the vertices that it has beside G, and the subcells that it parts.
template <int d>
struct InnerFacet {
  std::array<int, d - 1> vertices;
  int k, l;
};

template <int d>
std::array<InnerFacet<d>, d*(d + 1) / 2> inner_facets() {
  std::array<InnerFacet<d>, d*(d + 1) / 2> facets;
  std::size_t next = 0;
  for (int k = d - 1; k >= 0; --k)
    for (int l = d; l > k; --l, ++next) {
      facets[next].k = k;
      facets[next].l = l;
      std::size_t place = 0;
      for (int i = 0; i <= d; ++i)
        if (i != k && i != l) facets[next].vertices[place++] = i;
    }
  return facets;
}

/// Columns of facet loads over the measures of their facets.
template <int d>
FacetLoads<d> over_measures(FacetLoads<d> loads,
                            const CellCorners<d>& corners) {
  const CellCorners<d> vectors = facet_vectors(corners);
  for (int k = 0; k <= d; ++k)
    loads.template middleCols<d>(d * k) /= vectors.col(k).norm();
  return loads;
}

}  // namespace

template <int d>
CellBodyLoads<d> divergences(const CellCorners<d>& corners,
                             const SubcellStress<d>& stress) {
  CellBodyLoads<d> result = CellBodyLoads<d>::Zero();
  for (int k = 0; k <= d; ++k) {
    const CellCorners<d> x = subcell(corners, k);
    const CellCorners<d> gradients = facet_vectors(x) / (-d * volume_of(x));
    for (int c = 0; c <= d; ++c)
      result.col(k) += traction(stress.col((d + 1) * k + c), gradients.col(c));
  }
  return result;
}

template <int d>
InnerJumps<d> inner_jumps(const CellCorners<d>& corners,
                          const SubcellStress<d>& stress) {
  InnerJumps<d> jumps;
  int column = 0;
  for (const auto& [vertices, k, l] : inner_facets<d>()) {
    MatrixOf<d> facet;
    for (int i = 0; i < d - 1; ++i) facet.col(i) = corners.col(vertices[i]);
    facet.col(d - 1) = corners.rowwise().mean();
    const VectorOf<d> n = facet_vector(facet).normalized();
    for (int i = 0; i < d; ++i) {
      const int in_k = i < d - 1 ? place_on_facet<d>(k, vertices[i]) : d,
                in_l = i < d - 1 ? place_on_facet<d>(l, vertices[i]) : d;
      jumps.col(column++) = traction(
          stress.col((d + 1) * k + in_k) - stress.col((d + 1) * l + in_l), n);
    }
  }
  return jumps;
}

template <int d>
FacetLoads<d> facet_loads_of(const CellCorners<d>& corners,
                             const SubcellStress<d>& stress) {
  const CellCorners<d> vectors = facet_vectors(corners);
  FacetLoads<d> loads;
  for (int k = 0; k <= d; ++k) {
    MatrixOf<d> density;
    for (int j = 0; j < d; ++j)
      density.col(j) = traction(stress.col((d + 1) * k + j), vectors.col(k));
    loads.template middleCols<d>(d * k) = facet_moments_of<d>(density, 1);
  }
  return loads;
}

template <int d>
CellBodyLoads<d> body_force_of(const CellBodyLoads<d>& body_loads,
                               double volume) {
  return body_loads * force_per_body_load<d>(volume).transpose();
}

template <int d>
StressConditions<d>::StressConditions(const CellCorners<d>& corners) {
  using Size = Sizes<d>;
  const double volume = volume_of(corners), size = std::pow(volume, 1.0 / d);
  matrix.resize(Size::before_loads + Size::loads, Size::coefficients);
  for (int unit = 0; unit < matrix.cols(); ++unit) {
    SubcellStress<d> stress = SubcellStress<d>::Zero();
    stress.reshaped()[unit] = 1;
    matrix.col(unit) << size * divergences(corners, stress).reshaped(),
        inner_jumps(corners, stress).reshaped(),
        over_measures<d>(facet_loads_of(corners, stress), corners).reshaped();
  }
  right.setZero(matrix.rows(), Size::loads + Size::body_loads);
  right.block(Size::before_loads, 0, Size::loads, Size::loads).diagonal() =
      over_measures<d>(FacetLoads<d>::Ones(), corners).reshaped();
  for (int unit = 0; unit < Size::body_loads; ++unit) {
    CellBodyLoads<d> loads = CellBodyLoads<d>::Zero();
    loads.reshaped()[unit] = 1;
    right.col(Size::loads + unit).template head<Size::body_loads>() =
        -size * body_force_of<d>(loads, volume).reshaped();
  }
}

template CellBodyLoads<FFCONTACT_DIMENSION> divergences<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const SubcellStress<FFCONTACT_DIMENSION>&);
template InnerJumps<FFCONTACT_DIMENSION> inner_jumps<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const SubcellStress<FFCONTACT_DIMENSION>&);
template FacetLoads<FFCONTACT_DIMENSION> facet_loads_of<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const SubcellStress<FFCONTACT_DIMENSION>&);
template CellBodyLoads<FFCONTACT_DIMENSION> body_force_of<FFCONTACT_DIMENSION>(
    const CellBodyLoads<FFCONTACT_DIMENSION>&, double);
template struct StressConditions<FFCONTACT_DIMENSION>;

}  // namespace ffcontact
