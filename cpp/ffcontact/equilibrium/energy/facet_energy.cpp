// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/facet_energy.hpp"

#include <Eigen/LU>

namespace ffcontact {

namespace {

/// Of a symmetric matrix of n rows.
constexpr int packed_size(int n) { return n * (n + 1) / 2; }
constexpr int packed_place(int row, int column) {
  return row * (row + 1) / 2 + column;
}

template <int d>
struct Packed {
  static constexpr int voigt = voigt_size<d>,
                       loads = CompositeElement<d>::loads,
                       values = CompositeElement<d>::values;
  static constexpr int pairs = packed_size(voigt), form = packed_size(loads);
};

/// The lower triangles of P_ab, one a column, b <= a.
template <int d, class Scalar = double>
using PairForms = Matrix<Scalar, Packed<d>::form, Packed<d>::pairs>;
template <int d>
using Stresses =
    Matrix<double, Packed<d>::voigt * Packed<d>::values, Packed<d>::loads>;

/// The stress of a unit load on the reference cell's facets, with what it balances in the
/// body.
template <int d>
SubcellStress<d> unit_stress(int unit) {
  FacetLoads<d> loads = FacetLoads<d>::Zero();
  loads.reshaped()[unit] = 1;
  return composite_stress<d>(reference_cell<d>(), loads,
                             balancing_body_loads<d>(loads));
}

/// Of all unit loads, column-major.
template <int d>
const Stresses<d>& stresses_of_loads() {
  static const Stresses<d> stresses = [] {
    Stresses<d> columns;
    for (int unit = 0; unit < columns.cols(); ++unit)
      columns.col(unit) = unit_stress<d>(unit).reshaped();
    return columns;
  }();
  return stresses;
}

/// Rows: one Voigt component at the corners of the subcells.
template <int d>
auto component_of(const Stresses<d>& stresses, int component) {
  Matrix<double, Packed<d>::values, Packed<d>::loads> rows =
      stresses(Eigen::seqN(component, Eigen::fix<Packed<d>::values>,
                           Eigen::fix<Packed<d>::voigt>),
               Eigen::all);
  return rows;
}

/// Values at the corners of the reference cell's subcells, one column each, times
/// int phi_a phi_b: the volume of a subcell, 1 / (d! n), over n (n + 1), n = d + 1, times
/// 1 + delta.
template <int d, int rows>
auto massed(Matrix<double, rows, Packed<d>::values> values) {
  constexpr int n = d + 1;
  constexpr double own = d == 3 ? 1.0 / 480 : 1.0 / 72;
  for (int k = 0; k < n * n; k += n) {
    auto of_subcell = values.template middleCols<n>(k);
    const Matrix<double, rows, 1> sum = of_subcell.rowwise().sum();
    of_subcell = own * (of_subcell.colwise() + sum);
  }
  return values;
}

template <int d>
PairForms<d> reference_pair_forms() {
  constexpr int loads = Packed<d>::loads;
  const Stresses<d>& stresses = stresses_of_loads<d>();
  PairForms<d> forms;
  for (int a = 0; a < voigt_size<d>; ++a)
    for (int b = 0; b <= a; ++b) {
      CellForm<d> form =
          massed<d, loads>(component_of<d>(stresses, a).transpose()) *
          component_of<d>(stresses, b);
      if (a != b) form += form.transpose().eval();
      for (int r = 0; r < form.rows(); ++r)
        for (int c = 0; c <= r; ++c)
          forms(packed_place(r, c), packed_place(a, b)) = form(r, c);
    }
  return forms;
}

template <int d, class Scalar>
const PairForms<d, Scalar>& pair_forms() {
  static const PairForms<d, Scalar> forms =
      reference_pair_forms<d>().template cast<Scalar>();
  return forms;
}

/// M_ab, b <= a.
template <int d>
Matrix<double, Packed<d>::pairs, 1> pair_weights(
    const MatrixOf<d>& B, const VoigtMatrix<d>& compliance) {
  const VoigtMatrix<d> T = piola_voigt<d>(B);
  const VoigtMatrix<d> M = T.transpose() * compliance * T / B.determinant();
  Matrix<double, Packed<d>::pairs, 1> weights;
  for (int a = 0; a < voigt_size<d>; ++a)
    for (int b = 0; b <= a; ++b) weights[packed_place(a, b)] = M(a, b);
  return weights;
}

template <int d, class Scalar>
CellForm<d, Scalar> unpacked(const Matrix<Scalar, Packed<d>::form, 1>& packed) {
  CellForm<d, Scalar> full;
  for (int r = 0; r < full.rows(); ++r)
    for (int c = 0; c <= r; ++c)
      full(r, c) = full(c, r) = packed[packed_place(r, c)];
  return full;
}

template <int d, class Scalar>
using Bases = std::array<
    Matrix<Scalar, CompositeElement<d>::moments, CompositeElement<d>::moments>,
    d + 1>;

/// Columns of the loads on the reference cell.
template <int d, class Scalar>
Bases<d, Scalar> pulled_back(const MatrixOf<d>& B, const FacetBases<d>& basis) {
  const MatrixOf<d> inverse = B.inverse();
  Bases<d, Scalar> columns;
  for (int k = 0; k <= d; ++k)
    for (int j = 0; j < basis[k].rows(); j += d)
      columns[k].template middleRows<d>(j) =
          (inverse * basis[k].template middleRows<d>(j))
              .template cast<Scalar>();
  return columns;
}

/// A C, C = diag(C_1, .., C_n), column by column.
template <int d, class Scalar>
CellForm<d, Scalar> times_blocks(const CellForm<d, Scalar>& A,
                                 const Bases<d, Scalar>& C) {
  constexpr int size = CompositeElement<d>::moments;
  CellForm<d, Scalar> product;
  for (int k = 0; k <= d; ++k)
    for (int column = 0; column < size; ++column) {
      Matrix<Scalar, CompositeElement<d>::loads, 1> sum =
          A.col(size * k) * C[k](0, column);
      for (int row = 1; row < size; ++row)
        sum += A.col(size * k + row) * C[k](row, column);
      product.col(size * k + column) = sum;
    }
  return product;
}

}  // namespace

template <int d, class Scalar>
CellForm<d, Scalar> facet_energy(const CellCorners<d>& corners,
                                 const VoigtMatrix<d>& compliance,
                                 const FacetBases<d>& basis) {
  const MatrixOf<d> B = piola_matrix(corners);
  const Bases<d, Scalar> columns = pulled_back<d, Scalar>(B, basis);
  const Matrix<Scalar, Packed<d>::pairs, 1> weights =
      pair_weights<d>(B, compliance).template cast<Scalar>();
  const Matrix<Scalar, Packed<d>::form, 1> packed =
      pair_forms<d, Scalar>() * weights;
  const CellForm<d, Scalar> half =
      times_blocks<d, Scalar>(unpacked<d, Scalar>(packed), columns).transpose();
  return times_blocks<d, Scalar>(half, columns);
}

template <int d>
CellVector<d> facet_slope(const CellCorners<d>& corners,
                          const VoigtMatrix<d>& compliance,
                          const SubcellStress<d>& stress,
                          const FacetBases<d>& basis) {
  constexpr int size = CompositeElement<d>::moments;
  const MatrixOf<d> B = piola_matrix(corners);
  // int sigma : C^-1 tau = E : s with tau = T s / det B
  const SubcellStress<d> E = massed<d, voigt_size<d>>(
      piola_voigt<d>(B).transpose() * compliance * stress);
  FacetLoads<d> on_loads;
  on_loads.reshaped() = stresses_of_loads<d>().transpose() * E.reshaped();
  on_loads = (B.inverse().transpose() * on_loads).eval();
  CellVector<d> slope;
  for (int k = 0; k <= d; ++k)
    slope.template segment<size>(size * k) =
        basis[k].transpose() *
        on_loads.template middleCols<d>(d * k).reshaped();
  return slope;
}

template CellForm<FFCONTACT_DIMENSION>
facet_energy<FFCONTACT_DIMENSION, double>(

    const CellCorners<FFCONTACT_DIMENSION>&,
    const VoigtMatrix<FFCONTACT_DIMENSION>&,
    const FacetBases<FFCONTACT_DIMENSION>&);
template CellForm<FFCONTACT_DIMENSION, float> facet_energy<
    FFCONTACT_DIMENSION, float>(const CellCorners<FFCONTACT_DIMENSION>&,
                                const VoigtMatrix<FFCONTACT_DIMENSION>&,
                                const FacetBases<FFCONTACT_DIMENSION>&);
template CellVector<FFCONTACT_DIMENSION> facet_slope<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const VoigtMatrix<FFCONTACT_DIMENSION>&,
    const SubcellStress<FFCONTACT_DIMENSION>&,
    const FacetBases<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
