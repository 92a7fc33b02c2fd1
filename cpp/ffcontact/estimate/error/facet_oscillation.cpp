// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/facet_oscillation.hpp"

#include <Eigen/LU>

#include "ffcontact/linear/dense/symmetric_eigen.hpp"

namespace ffcontact {

namespace {

/// T' C^-1 T / det B on tensors as vectors whose length is Frobenius' norm.
template <int d>
VoigtMatrix<d> transported(const MatrixOf<d>& B,
                           const VoigtMatrix<d>& compliance) {
  VoigtVector<d> scale = VoigtVector<d>::Constant(std::sqrt(0.5));
  scale.template head<d>().setOnes();
  const VoigtMatrix<d> T = piola_voigt<d>(B) * scale.asDiagonal();
  return T.transpose() * compliance * T / B.determinant();
}

/// From the regular cell to another one.
template <int d>
MatrixOf<d> from_regular_cell(const CellCorners<d>& corners) {
  return piola_matrix<d>(corners) *
         piola_matrix<d>(regular_cell<d>()).inverse();
}

/// lambda kappa^2 A / A_1
template <int d>
double oscillation_factor(const MatrixOf<d>& B,
                          const VoigtMatrix<d>& compliance, double measure) {
  const double lambda = symmetric_eigen(transported<d>(B, compliance))
                            .values.maxCoeff(),
               regular_measure = d == 2 ? 1 : std::sqrt(3.0) / 4;
  return lambda * traction_constant<d> * measure / regular_measure;
}

}  // namespace

template <int d>
CellCorners<d> regular_cell() {
  CellCorners<d> corners = CellCorners<d>::Zero();
  corners(0, 1) = 1;
  corners.template block<2, 1>(0, 2) << 0.5, std::sqrt(0.75);
  if constexpr (d == 3)
    corners.col(3) << 0.5, std::sqrt(0.75) / 3, std::sqrt(2.0 / 3);
  return corners;
}

template <int d>
double facet_oscillation_square(const CellCorners<d>& corners,
                                const VoigtMatrix<d>& compliance,
                                double measure, const MatrixOf<d>& square) {
  const MatrixOf<d> B = from_regular_cell<d>(corners), back = B.inverse();
  return oscillation_factor<d>(B, compliance, measure) *
         (back * square * back.transpose()).trace();
}

template <int d>
MatrixOf<d> facet_oscillation_form(const CellCorners<d>& corners,
                                   const VoigtMatrix<d>& compliance,
                                   double measure) {
  const MatrixOf<d> B = from_regular_cell<d>(corners), back = B.inverse();
  return oscillation_factor<d>(B, compliance, measure) * back.transpose() *
         back;
}

template CellCorners<FFCONTACT_DIMENSION> regular_cell();
template double facet_oscillation_square<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const VoigtMatrix<FFCONTACT_DIMENSION>&, double,
    const MatrixOf<FFCONTACT_DIMENSION>&);
template MatrixOf<FFCONTACT_DIMENSION> facet_oscillation_form(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const VoigtMatrix<FFCONTACT_DIMENSION>&, double);

}  // namespace ffcontact
