// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/equilibrium/stress/stress_conditions.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"

namespace ffcontact {

namespace {

template <int d>
constexpr int coefficients = SubcellStress<d>::SizeAtCompileTime;
template <int d>
constexpr int all_loads =
    CompositeElement<d>::loads + CompositeElement<d>::body_loads;
/// One force a column.
template <int d>
using CellLoads = Matrix<double, d, all_loads<d> / d>;

/// Corner stresses (by columns) from facet and body loads.
template <int d>
const auto& reference_map() {
  static const Matrix<double, coefficients<d>, all_loads<d>> map = [] {
    const StressConditions<d> conditions(reference_cell<d>());
    return least_squares_of_columns(conditions.matrix, conditions.right);
  }();
  return map;
}

/// Least height over longest edge below which a cell is thin.
template <int d>
constexpr double thin = d == 2 ? 0.0175 : 0.01;

template <int d>
double longest_edge(const CellCorners<d>& corners) {
  double square = 0;
  for (int i = 0; i < d; ++i)
    for (int j = i + 1; j <= d; ++j)
      square =
          std::max(square, (corners.col(i) - corners.col(j)).squaredNorm());
  return std::sqrt(square);
}

/// The least height is d V / (largest A).
template <int d>
bool is_thin(const CellCorners<d>& corners) {
  const double largest_facet =
      facet_vectors(corners).colwise().norm().maxCoeff();
  return d * volume_of(corners) <
         thin<d> * longest_edge(corners) * largest_facet;
}

/// Backward stable: what is left of each condition is of the size of rounding.
template <int d>
SubcellStress<d> solved_directly(const CellCorners<d>& corners,
                                 const CellLoads<d>& loads) {
  const StressConditions<d> conditions(corners.colwise() -
                                       corners.rowwise().mean());
  const VectorXd stress =
      least_squares(conditions.matrix, conditions.right * loads.reshaped());
  return Map<const SubcellStress<d>>(stress.data());
}

template <int d>
SubcellStress<d> by_piola(const CellCorners<d>& corners,
                          const CellLoads<d>& loads) {
  const MatrixOf<d> B = piola_matrix(corners);
  const CellLoads<d> pulled_back = B.inverse() * loads;
  SubcellStress<d> s;
  s.reshaped() = reference_map<d>() * pulled_back.reshaped();
  return piola_voigt<d>(B) / B.determinant() * s;
}

/// Integrals of products of corner values over a subcell of volume V:
/// V / ((d + 1) (d + 2)) (1 + delta).
template <int d>
double subcell_mass(double volume, int a, int b) {
  return volume / (a == b ? (d + 1) * (d + 2) / 2 : (d + 1) * (d + 2));
}

}  // namespace

template <int d>
VoigtMatrix<d> piola_voigt(const MatrixOf<d>& B) {
  constexpr auto& place = voigt_place<d>;
  VoigtMatrix<d> T = VoigtMatrix<d>::Zero();
  for (int i = 0; i < d; ++i)
    for (int j = i; j < d; ++j)
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b)
          T(place[i][j], place[a][b]) += B(i, a) * B(j, b);
  return T;
}

template <int d>
SubcellStress<d> composite_stress(const CellCorners<d>& corners,
                                  const FacetLoads<d>& on_facets,
                                  const CellBodyLoads<d>& body_loads) {
  CellLoads<d> loads;
  loads << on_facets, body_loads;
  return is_thin(corners) ? solved_directly(corners, loads)
                          : by_piola(corners, loads);
}

template <int d>
CellBodyLoads<d> balancing_body_loads(const FacetLoads<d>& on_facets) {
  return (-1.0 / (d + 1) * on_facets.rowwise().sum())
      .template replicate<1, d + 1>();
}

template <int d>
double energy(const CellCorners<d>& corners, const VoigtMatrix<d>& compliance,
              const SubcellStress<d>& stress) {
  constexpr int n = d + 1;
  const double of_subcell = volume_of(corners) / n;
  const SubcellStress<d> strain = compliance * stress;
  double sum = 0;
  for (int k = 0; k < n * n; k += n)
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        sum += subcell_mass<d>(of_subcell, a, b) *
               stress.col(k + a).dot(strain.col(k + b));
  return sum;
}

template VoigtMatrix<FFCONTACT_DIMENSION> piola_voigt<FFCONTACT_DIMENSION>(
    const MatrixOf<FFCONTACT_DIMENSION>&);
template SubcellStress<FFCONTACT_DIMENSION> composite_stress<
    FFCONTACT_DIMENSION>(const CellCorners<FFCONTACT_DIMENSION>&,
                         const FacetLoads<FFCONTACT_DIMENSION>&,
                         const CellBodyLoads<FFCONTACT_DIMENSION>&);
template CellBodyLoads<FFCONTACT_DIMENSION> balancing_body_loads<
    FFCONTACT_DIMENSION>(const FacetLoads<FFCONTACT_DIMENSION>&);
template double energy<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const VoigtMatrix<FFCONTACT_DIMENSION>&,
    const SubcellStress<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
