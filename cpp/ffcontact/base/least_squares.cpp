// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/least_squares.hpp"

#include <Eigen/LU>
#include <Eigen/QR>

namespace ffcontact {

namespace {

template <class Decomposition>
Decomposition decomposed(const Eigen::MatrixXd& A, PivotThreshold threshold) {
  Decomposition decomposition(A.rows(), A.cols());
  if (threshold.value > 0) decomposition.setThreshold(threshold.value);
  decomposition.compute(A);
  return decomposition;
}

using Orthogonal = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;

}  // namespace

Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, PivotThreshold threshold) {
  return decomposed<Orthogonal>(A, threshold).solve(b);
}

Eigen::MatrixXd least_squares_of_columns(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return decomposed<Orthogonal>(A, {}).solve(B);
}

Eigen::MatrixXd kernel_basis(const Eigen::MatrixXd& A, PivotThreshold threshold) {
  const auto lu = decomposed<Eigen::FullPivLU<Eigen::MatrixXd>>(A, threshold);
  if (lu.dimensionOfKernel() == 0) return Eigen::MatrixXd(A.cols(), 0);
  return lu.kernel();
}

}  // namespace ffcontact
