// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/least_squares.hpp"

#include <Eigen/LU>
#include <Eigen/QR>

namespace ffcontact {

namespace {

template <class Decomposition>
Decomposition decomposed(const MatrixXd& A, PivotThreshold threshold) {
  Decomposition decomposition(A.rows(), A.cols());
  if (threshold.value > 0) decomposition.setThreshold(threshold.value);
  decomposition.compute(A);
  return decomposition;
}

using Orthogonal = Eigen::CompleteOrthogonalDecomposition<MatrixXd>;

}  // namespace

VectorXd least_squares(const MatrixXd& A, const VectorXd& b,
                       PivotThreshold threshold) {
  return decomposed<Orthogonal>(A, threshold).solve(b);
}

MatrixXd least_squares_of_columns(const MatrixXd& A, const MatrixXd& B) {
  return decomposed<Orthogonal>(A, {}).solve(B);
}

MatrixXd kernel_basis(const MatrixXd& A, PivotThreshold threshold) {
  const auto lu = decomposed<Eigen::FullPivLU<MatrixXd>>(A, threshold);
  if (lu.dimensionOfKernel() == 0) return MatrixXd(A.cols(), 0);
  return lu.kernel();
}

}  // namespace ffcontact
