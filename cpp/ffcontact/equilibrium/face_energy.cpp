// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/face_energy.hpp"

#include <Eigen/LU>

namespace ffcontact {

namespace {

constexpr int voigt_pairs = 21, packed_form = 36 * 37 / 2;

using PackedForm = Matrix<double, packed_form, 1>;
/// The lower triangles of P_ab, one a column, b <= a.
using PairForms = Matrix<double, packed_form, voigt_pairs>;

constexpr int packed_place(int row, int column) {
  return row * (row + 1) / 2 + column;
}

/// Stresses of the unit loads on the faces, those that they balance in the body included:
/// of each Voigt component, at the 16 corners (rows) for the 36 loads.
using UnitStresses = std::array<Matrix<double, 16, 36>, 6>;

UnitStresses unit_stresses() {
  UnitStresses stresses;
  for (int unit = 0; unit < 36; ++unit) {
    FaceLoads loads = FaceLoads::Zero();
    loads.reshaped()[unit] = 1;
    const SolidStress stress = composite_stress(reference_tetrahedron(), loads,
                                                balancing_body_loads(loads));
    for (int a = 0; a < 6; ++a)
      stresses[a].col(unit) = stress.row(a).transpose();
  }
  return stresses;
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
  const UnitStresses stress = unit_stresses();
  const Matrix<double, 16, 16> masses = reference_masses();
  PairForms forms;
  for (int a = 0; a < 6; ++a)
    for (int b = 0; b <= a; ++b) {
      FaceForm form = stress[a].transpose() * masses * stress[b];
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

FaceForm unpacked(const PackedForm& form) {
  FaceForm full;
  for (int r = 0; r < 36; ++r)
    for (int c = 0; c <= r; ++c)
      full(r, c) = full(c, r) = form[packed_place(r, c)];
  return full;
}

}  // namespace

FaceForm face_energy(const TetrahedronCorners& corners,
                     const Matrix<double, 6, 6>& compliance,
                     const std::array<Matrix9d, 4>& basis) {
  const Matrix3d B = piola_matrix(corners), inverse = B.inverse();
  const FaceForm reference =
      unpacked(pair_forms() * pair_weights(B, compliance));

  std::array<Matrix9d, 4> pulled_back;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 3; ++j)
      pulled_back[k].middleRows<3>(3 * j) =
          inverse * basis[k].middleRows<3>(3 * j);

  FaceForm form;
  for (int k = 0; k < 4; ++k)
    for (int l = 0; l <= k; ++l) {
      const Matrix9d half =
          reference.block<9, 9>(9 * k, 9 * l) * pulled_back[l];
      form.block<9, 9>(9 * k, 9 * l) = pulled_back[k].transpose() * half;
      form.block<9, 9>(9 * l, 9 * k) =
          form.block<9, 9>(9 * k, 9 * l).transpose().eval();
    }
  return form;
}

}  // namespace ffcontact
