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
  const MatrixOf<d> B = piola_matrix<d>(corners) *
                        piola_matrix<d>(regular_cell<d>()).inverse(),
                    back = B.inverse();
  const double lambda = symmetric_eigen(transported<d>(B, compliance))
                            .values.maxCoeff(),
               regular_measure = d == 2 ? 1 : std::sqrt(3.0) / 4;
  return lambda * traction_constant<d> * measure / regular_measure *
         (back * square * back.transpose()).trace();
}

template CellCorners<FFCONTACT_DIMENSION> regular_cell();
template double facet_oscillation_square<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const VoigtMatrix<FFCONTACT_DIMENSION>&, double,
    const MatrixOf<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
