// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>

#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

namespace {

template <int d>
struct Sizes : CompositeElement<d> {
  static constexpr int coefficients =
                           voigt_size<d> * CompositeElement<d>::values,
                       body_loads = d * (d + 1),
                       jumps = d * d * d * (d + 1) / 2;
};

constexpr double factorial(int n) { return n > 1 ? n * factorial(n - 1) : 1; }

/// Of the reference cell.
template <int d>
constexpr double reference_volume = 1 / factorial(d);

template <int d>
VectorOf<d> barycentre(const CellCorners<d>& corners) {
  return corners.rowwise().mean();
}

template <int d>
CellCorners<d> subcell(const CellCorners<d>& corners, int k) {
  CellCorners<d> x;
  for (int j = 0; j < d; ++j) x.col(j) = corners.col(vertex_of_facet<d>(k, j));
  x.col(d) = barycentre<d>(corners);
  return x;
}

/// Gradients of the barycentric coordinates.
template <int d>
CellCorners<d> gradients(const CellCorners<d>& corners) {
  const MatrixOf<d> others = piola_matrix<d>(corners).inverse().transpose();
  CellCorners<d> columns;
  columns << -others.rowwise().sum(), others;
  return columns;
}

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

/// The conditions of the header on the reference cell, one column for every coefficient:
/// divergences, jumps, moments.
template <int d>
MatrixXd reference_conditions() {
  using Size = Sizes<d>;
  const CellCorners<d> corners = reference_cell<d>();
  MatrixXd conditions(Size::body_loads + Size::jumps + Size::loads,
                      Size::coefficients);
  for (int unit = 0; unit < Size::coefficients; ++unit) {
    SubcellStress<d> stress = SubcellStress<d>::Zero();
    stress.reshaped()[unit] = 1;
    conditions.col(unit) << divergences<d>(corners, stress).reshaped(),
        inner_jumps<d>(corners, stress).reshaped(),
        facet_loads_of<d>(corners, stress).reshaped();
  }
  return conditions;
}

/// What the conditions are equal to for unit loads.
template <int d>
MatrixXd reference_right_sides() {
  using Size = Sizes<d>;
  constexpr int before = Size::body_loads + Size::jumps;
  MatrixXd right =
      MatrixXd::Zero(before + Size::loads, Size::loads + Size::body_loads);
  for (int unit = 0; unit < Size::loads; ++unit) right(before + unit, unit) = 1;
  for (int unit = 0; unit < Size::body_loads; ++unit) {
    CellBodyLoads<d> loads = CellBodyLoads<d>::Zero();
    loads.reshaped()[unit] = 1;
    right.col(Size::loads + unit).template head<Size::body_loads>() =
        -body_force_of<d>(loads, reference_volume<d>).reshaped();
  }
  return right;
}

/// Corner stresses (by columns) from facet and body loads.
template <int d>
const auto& reference_map() {
  using Map = Matrix<double, Sizes<d>::coefficients,
                     Sizes<d>::loads + Sizes<d>::body_loads>;
  static const Map map = least_squares_of_columns(reference_conditions<d>(),
                                                  reference_right_sides<d>());
  return map;
}

/// Integrals of products of corner values over a subcell of volume V:
/// V / ((d + 1) (d + 2)) (1 + delta).
template <int d>
double subcell_mass(double volume, int a, int b) {
  return volume / (a == b ? (d + 1) * (d + 2) / 2 : (d + 1) * (d + 2));
}

}  // namespace

template <int d>
CellCorners<d> reference_cell() {
  CellCorners<d> corners;
  corners << VectorOf<d>::Zero(), MatrixOf<d>::Identity();
  return corners;
}

template <int d>
CellCorners<d> facet_vectors(const CellCorners<d>& corners) {
  CellCorners<d> vectors;
  for (int k = 0; k <= d; ++k) {
    const MatrixOf<d> facet = corners(Eigen::all, facet_corners<d>[k]);
    vectors.col(k) = facet_vector(facet);
  }
  return vectors;
}

template <int d>
MatrixOf<d> piola_matrix(const CellCorners<d>& corners) {
  return corners.template rightCols<d>().colwise() - corners.col(0);
}

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
  const MatrixOf<d> B = piola_matrix<d>(corners), inverse = B.inverse();
  Matrix<double, d, (d + 1) * (d + 1)> pulled_back;
  pulled_back << inverse * on_facets, inverse * body_loads;
  SubcellStress<d> s;
  s.reshaped() = reference_map<d>() * pulled_back.reshaped();
  return piola_voigt<d>(B) / B.determinant() * s;
}

template <int d>
CellBodyLoads<d> balancing_body_loads(const FacetLoads<d>& on_facets) {
  return (-1.0 / (d + 1) * on_facets.rowwise().sum())
      .template replicate<1, d + 1>();
}

template <int d>
CellBodyLoads<d> body_force_of(const CellBodyLoads<d>& body_loads,
                               double volume) {
  return body_loads * force_per_body_load<d>(volume).transpose();
}

template <int d>
double energy(const CellCorners<d>& corners, const VoigtMatrix<d>& compliance,
              const SubcellStress<d>& stress) {
  constexpr int n = d + 1;
  const double volume =
      piola_matrix<d>(corners).determinant() / (factorial(d) * n);
  const SubcellStress<d> strain = compliance * stress;
  double sum = 0;
  for (int k = 0; k < n * n; k += n)
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        sum += subcell_mass<d>(volume, a, b) *
               stress.col(k + a).dot(strain.col(k + b));
  return sum;
}

template <int d>
CellBodyLoads<d> divergences(const CellCorners<d>& corners,
                             const SubcellStress<d>& stress) {
  CellBodyLoads<d> result = CellBodyLoads<d>::Zero();
  for (int k = 0; k <= d; ++k) {
    const CellCorners<d> slope = gradients<d>(subcell<d>(corners, k));
    for (int c = 0; c <= d; ++c)
      result.col(k) += traction(stress.col((d + 1) * k + c), slope.col(c));
  }
  return result;
}

template <int d>
Matrix<double, d, d * d*(d + 1) / 2> inner_jumps(
    const CellCorners<d>& corners, const SubcellStress<d>& stress) {
  Matrix<double, d, d * d*(d + 1) / 2> jumps;
  int column = 0;
  for (const auto& [vertices, k, l] : inner_facets<d>()) {
    MatrixOf<d> facet;
    for (int i = 0; i < d - 1; ++i) facet.col(i) = corners.col(vertices[i]);
    facet.col(d - 1) = barycentre<d>(corners);
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
  const CellCorners<d> vectors = facet_vectors<d>(corners);
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
MatrixOf<d> facet_density(const MatrixOf<d>& moments, double measure) {
  const VectorOf<d> part = 1.0 / (d + 1) * moments.rowwise().sum();
  return d * (d + 1) / measure * (moments.colwise() - part);
}

template <int d>
MatrixOf<d> facet_moments_of(const MatrixOf<d>& density, double measure) {
  const VectorOf<d> sum = density.rowwise().sum();
  return measure / (d * (d + 1)) * (density.colwise() + sum);
}

template CellCorners<FFCONTACT_DIMENSION> reference_cell<FFCONTACT_DIMENSION>();
template CellCorners<FFCONTACT_DIMENSION> facet_vectors<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&);
template SubcellStress<FFCONTACT_DIMENSION> composite_stress<
    FFCONTACT_DIMENSION>(const CellCorners<FFCONTACT_DIMENSION>&,
                         const FacetLoads<FFCONTACT_DIMENSION>&,
                         const CellBodyLoads<FFCONTACT_DIMENSION>&);
template CellBodyLoads<FFCONTACT_DIMENSION> balancing_body_loads<
    FFCONTACT_DIMENSION>(const FacetLoads<FFCONTACT_DIMENSION>&);
template CellBodyLoads<FFCONTACT_DIMENSION> body_force_of<FFCONTACT_DIMENSION>(
    const CellBodyLoads<FFCONTACT_DIMENSION>&, double);
template Matrix<double, FFCONTACT_DIMENSION, FFCONTACT_DIMENSION>
piola_matrix<FFCONTACT_DIMENSION>(const CellCorners<FFCONTACT_DIMENSION>&);
template VoigtMatrix<FFCONTACT_DIMENSION> piola_voigt<FFCONTACT_DIMENSION>(
    const Matrix<double, FFCONTACT_DIMENSION, FFCONTACT_DIMENSION>&);
template double energy<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const VoigtMatrix<FFCONTACT_DIMENSION>&,
    const SubcellStress<FFCONTACT_DIMENSION>&);
template CellBodyLoads<FFCONTACT_DIMENSION> divergences<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const SubcellStress<FFCONTACT_DIMENSION>&);
template Matrix<double, FFCONTACT_DIMENSION,
                FFCONTACT_DIMENSION *
                    FFCONTACT_DIMENSION*(FFCONTACT_DIMENSION + 1) / 2>
inner_jumps<FFCONTACT_DIMENSION>(const CellCorners<FFCONTACT_DIMENSION>&,
                                 const SubcellStress<FFCONTACT_DIMENSION>&);
template FacetLoads<FFCONTACT_DIMENSION> facet_loads_of<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const SubcellStress<FFCONTACT_DIMENSION>&);
template Matrix<double, FFCONTACT_DIMENSION, FFCONTACT_DIMENSION>
facet_density<FFCONTACT_DIMENSION>(
    const Matrix<double, FFCONTACT_DIMENSION, FFCONTACT_DIMENSION>&, double);
template Matrix<double, FFCONTACT_DIMENSION, FFCONTACT_DIMENSION>
facet_moments_of<FFCONTACT_DIMENSION>(
    const Matrix<double, FFCONTACT_DIMENSION, FFCONTACT_DIMENSION>&, double);

}  // namespace ffcontact
