// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/dense_lu.hpp"

#include <cassert>
#include <cmath>
#include <utility>

extern "C" {
void dgetrf_(const int* rows, const int* columns, double* a, const int* stride,
             int* pivots, int* info);
void dgecon_(const char* norm, const int* n, const double* lu,
             const int* stride, const double* norm_of_a, double* rcond,
             double* work, int* iwork, int* info);
void dgetrs_(const char* transpose, const int* n, const int* columns,
             const double* lu, const int* stride, const int* pivots, double* b,
             const int* stride_of_b, int* info);
}

namespace ffcontact {

DenseLu::DenseLu(MatrixXd matrix)
    : factors_(std::move(matrix)),
      pivots_(factors_.rows()),
      norm_(factors_.cwiseAbs().colwise().sum().maxCoeff()) {
  assert(factors_.rows() == factors_.cols() && factors_.rows() > 0);
  const int n = static_cast<int>(factors_.rows());
  int info = 0;  // a zero pivot shows in the condition number
  dgetrf_(&n, &n, factors_.data(), &n, pivots_.data(), &info);
}

double DenseLu::reciprocal_condition() const {
  const int n = static_cast<int>(factors_.rows());
  VectorXd work(4 * n);
  VectorXi integer_work(n);
  double result = 0;
  int info = 0;
  dgecon_("1", &n, factors_.data(), &n, &norm_, &result, work.data(),
          integer_work.data(), &info);
  return info == 0 && std::isfinite(norm_) ? result : 0;
}

VectorXd DenseLu::solve(VectorXd right) const {
  assert(right.size() == factors_.rows());
  const int n = static_cast<int>(factors_.rows()), one = 1;
  int info = 0;
  dgetrs_("N", &n, &one, factors_.data(), &n, pivots_.data(), right.data(), &n,
          &info);
  return right;
}

}  // namespace ffcontact
