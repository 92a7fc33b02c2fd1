// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/face_energy.hpp"

#include <Eigen/LU>

namespace ffcontact {

namespace {

constexpr int voigt_pairs = 21, packed_form = 36 * 37 / 2;

/// The lower triangles of P_ab, one a column, b <= a.
using PairForms = Matrix<double, packed_form, voigt_pairs>;

constexpr int packed_place(int row, int column) {
  return row * (row + 1) / 2 + column;
}

/// The stress of a unit load on the reference tetrahedron's faces, with what it balances
/// in the body.
SolidStress unit_stress(int unit) {
  FaceLoads loads = FaceLoads::Zero();
  loads.reshaped()[unit] = 1;
  return composite_stress(reference_tetrahedron(), loads,
                          balancing_body_loads(loads));
}

/// Of all unit loads [6 x 16, column-major].
Matrix<double, 96, 36> unit_stresses() {
  Matrix<double, 96, 36> stresses;
  for (int unit = 0; unit < 36; ++unit)
    stresses.col(unit) = unit_stress(unit).reshaped();
  return stresses;
}

const Matrix<double, 96, 36>& stresses_of_loads() {
  static const Matrix<double, 96, 36> stresses = unit_stresses();
  return stresses;
}

/// Rows: one Voigt component at the 16 corners.
Matrix<double, 16, 36> component_of(const Matrix<double, 96, 36>& stresses,
                                    int component) {
  return stresses(Eigen::seqN(component, Eigen::fix<16>, Eigen::fix<6>),
                  Eigen::all);
}

/// int phi_a phi_b over the subtetrahedra of the reference tetrahedron, corner by corner.
Matrix<double, 16, 16> reference_masses() {
  Matrix<double, 16, 16> masses = Matrix<double, 16, 16>::Zero();
  Matrix4d own = Matrix4d::Constant(1.0 / 480);
  own.diagonal().setConstant(1.0 / 240);
  for (int k = 0; k < 16; k += 4) masses.block<4, 4>(k, k) = own;
  return masses;
}

PairForms reference_pair_forms() {
  const Matrix<double, 16, 16> masses = reference_masses();
  PairForms forms;
  for (int a = 0; a < 6; ++a)
    for (int b = 0; b <= a; ++b) {
      FaceForm form = component_of(stresses_of_loads(), a).transpose() *
                      masses * component_of(stresses_of_loads(), b);
      if (a != b) form += form.transpose().eval();
      for (int r = 0; r < 36; ++r)
        for (int c = 0; c <= r; ++c)
          forms(packed_place(r, c), packed_place(a, b)) = form(r, c);
    }
  return forms;
}

const PairForms& pair_forms() {
  static const PairForms forms = reference_pair_forms();
  return forms;
}

/// M_ab, b <= a.
Matrix<double, voigt_pairs, 1> pair_weights(
    const Matrix3d& B, const Matrix<double, 6, 6>& compliance) {
  const Matrix<double, 6, 6> T = piola_voigt(B);
  const Matrix<double, 6, 6> M =
      T.transpose() * compliance * T / B.determinant();
  Matrix<double, voigt_pairs, 1> weights;
  for (int a = 0; a < 6; ++a)
    for (int b = 0; b <= a; ++b) weights[packed_place(a, b)] = M(a, b);
  return weights;
}

template <class Scalar>
Matrix<Scalar, 36, 36> unpacked(const Matrix<Scalar, packed_form, 1>& form) {
  Matrix<Scalar, 36, 36> full;
  for (int r = 0; r < 36; ++r)
    for (int c = 0; c <= r; ++c)
      full(r, c) = full(c, r) = form[packed_place(r, c)];
  return full;
}

/// Columns of the loads on the reference tetrahedron.
std::array<Matrix9d, 4> pulled_back(const Matrix3d& B,
                                    std::array<Matrix9d, 4> basis) {
  const Matrix3d inverse = B.inverse();
  for (Matrix9d& columns : basis)
    for (int j = 0; j < 9; j += 3)
      columns.middleRows<3>(j) = (inverse * columns.middleRows<3>(j)).eval();
  return basis;
}

/// A C, C = diag(C_1, .., C_4), column by column.
template <class Scalar>
Matrix<Scalar, 36, 36> times_blocks(
    const Matrix<Scalar, 36, 36>& A,
    const std::array<Matrix<Scalar, 9, 9>, 4>& C) {
  Matrix<Scalar, 36, 36> product;
  for (int k = 0; k < 4; ++k)
    for (int column = 0; column < 9; ++column) {
      Matrix<Scalar, 36, 1> sum = A.col(9 * k) * C[k](0, column);
      for (int row = 1; row < 9; ++row)
        sum += A.col(9 * k + row) * C[k](row, column);
      product.col(9 * k + column) = sum;
    }
  return product;
}

template <class Scalar>
Matrix<Scalar, 36, 36> face_energy_of(
    const Matrix<Scalar, packed_form, voigt_pairs>& forms,
    const TetrahedronCorners& corners, const Matrix<double, 6, 6>& compliance,
    const std::array<Matrix9d, 4>& basis) {
  const Matrix3d B = piola_matrix(corners);
  const std::array<Matrix9d, 4> of_loads = pulled_back(B, basis);
  std::array<Matrix<Scalar, 9, 9>, 4> columns;
  for (int k = 0; k < 4; ++k) columns[k] = of_loads[k].cast<Scalar>();
  const Matrix<Scalar, voigt_pairs, 1> weights =
      pair_weights(B, compliance).cast<Scalar>();
  const Matrix<Scalar, packed_form, 1> packed = forms * weights;
  const Matrix<Scalar, 36, 36> half =
      times_blocks<Scalar>(unpacked<Scalar>(packed), columns).transpose();
  return times_blocks<Scalar>(half, columns);
}

}  // namespace

FaceForm face_energy(const TetrahedronCorners& corners,
                     const Matrix<double, 6, 6>& compliance,
                     const std::array<Matrix9d, 4>& basis) {
  return face_energy_of<double>(pair_forms(), corners, compliance, basis);
}

Matrix<float, 36, 36> rough_face_energy(const TetrahedronCorners& corners,
                                        const Matrix<double, 6, 6>& compliance,
                                        const std::array<Matrix9d, 4>& basis) {
  static const Matrix<float, packed_form, voigt_pairs> forms =
      pair_forms().cast<float>();
  return face_energy_of<float>(forms, corners, compliance, basis);
}

Matrix<double, 36, 1> face_slope(const TetrahedronCorners& corners,
                                 const Matrix<double, 6, 6>& compliance,
                                 const SolidStress& stress,
                                 const std::array<Matrix9d, 4>& basis) {
  const Matrix3d B = piola_matrix(corners);
  // int sigma : C^-1 tau = E : s with tau = T s / det B
  const SolidStress E =
      piola_voigt(B).transpose() * compliance * stress * reference_masses();
  const Matrix<double, 36, 1> on_loads =
      stresses_of_loads().transpose() * E.reshaped();
  const std::array<Matrix9d, 4> columns = pulled_back(B, basis);
  Matrix<double, 36, 1> slope;
  for (int k = 0; k < 4; ++k)
    slope.segment<9>(9 * k) =
        columns[k].transpose() * on_loads.segment<9>(9 * k);
  return slope;
}

}  // namespace ffcontact
