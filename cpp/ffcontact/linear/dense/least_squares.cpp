// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/least_squares.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <limits>

#include "ffcontact/linear/dense/blas.hpp"
#include "ffcontact/linear/dense/serial_blas.hpp"

namespace ffcontact {

namespace {

double threshold_for(const MatrixXd& A, PivotThreshold threshold) {
  const auto pivots = static_cast<double>(std::min(A.rows(), A.cols()));
  return threshold.value > 0 ? threshold.value
                             : pivots * std::numeric_limits<double>::epsilon();
}

constexpr int block = 32;  ///< columns, LAPACK's own

/// What gelsy works on with blocks.
int work_size_for(int rows, int columns, int count) {
  const int pivots = std::min(rows, columns);
  return pivots +
         std::max(2 * columns + block * (columns + 1), pivots + block * count);
}

MatrixXd minimum_norm_solution(MatrixXd A, const MatrixXd& B, double rcond) {
  const int m = static_cast<int>(A.rows()), n = static_cast<int>(A.cols()),
            stride = std::max(m, n), count = static_cast<int>(B.cols()),
            work_size = work_size_for(m, n, count);
  MatrixXd X(stride, count);
  X.topRows(m) = B;
  VectorXd work(work_size);
  VectorXi order = VectorXi::Zero(n);
  int rank = 0, info = 0;
  const SerialBlas serial;
  Blas<double>::gelsy(&m, &n, &count, A.data(), &m, X.data(), &stride,
                      order.data(), &rcond, &rank, work.data(), &work_size,
                      &info);
  return X.topRows(n);
}

}  // namespace

VectorXd least_squares(const MatrixXd& A, const VectorXd& b,
                       PivotThreshold threshold) {
  return minimum_norm_solution(A, b, threshold_for(A, threshold));
}

MatrixXd least_squares_of_columns(const MatrixXd& A, const MatrixXd& B) {
  return minimum_norm_solution(A, B, threshold_for(A, {}));
}

MatrixXd kernel_basis(const MatrixXd& A, PivotThreshold threshold) {
  Eigen::FullPivLU<MatrixXd> lu(A.rows(), A.cols());
  if (threshold.value > 0) lu.setThreshold(threshold.value);
  lu.compute(A);
  if (lu.dimensionOfKernel() == 0) return MatrixXd(A.cols(), 0);
  return lu.kernel();
}

MatrixXd orthonormal_basis(MatrixXd A) {
  assert(A.rows() >= A.cols());
  const int m = static_cast<int>(A.rows()), n = static_cast<int>(A.cols()),
            work_size = block * n;
  if (n == 0) return A;
  VectorXd factors(n), work(work_size);
  int info = 0;
  const SerialBlas serial;
  Blas<double>::geqrf(&m, &n, A.data(), &m, factors.data(), work.data(),
                      &work_size, &info);
  Blas<double>::orgqr(&m, &n, &n, A.data(), &m, factors.data(), work.data(),
                      &work_size, &info);
  return A;
}

}  // namespace ffcontact
