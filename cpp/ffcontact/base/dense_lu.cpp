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
void sgetrf_(const int* rows, const int* columns, float* a, const int* stride,
             int* pivots, int* info);
void sgecon_(const char* norm, const int* n, const float* lu, const int* stride,
             const float* norm_of_a, float* rcond, float* work, int* iwork,
             int* info);
void sgetrs_(const char* transpose, const int* n, const int* columns,
             const float* lu, const int* stride, const int* pivots, float* b,
             const int* stride_of_b, int* info);
}

namespace ffcontact {

namespace {

/// The routines of LAPACK for a scalar.
template <class Scalar>
struct Lapack;

template <>
struct Lapack<double> {
  static constexpr auto factorise = dgetrf_;
  static constexpr auto condition = dgecon_;
  static constexpr auto solve = dgetrs_;
};

template <>
struct Lapack<float> {
  static constexpr auto factorise = sgetrf_;
  static constexpr auto condition = sgecon_;
  static constexpr auto solve = sgetrs_;
};

}  // namespace

template <class Scalar>
LapackLu<Scalar>::LapackLu(Square matrix)
    : factors_(std::move(matrix)),
      pivots_(factors_.rows()),
      norm_(factors_.cwiseAbs().colwise().sum().maxCoeff()) {
  assert(factors_.rows() == factors_.cols() && factors_.rows() > 0);
  const int n = size();
  int info = 0;  // a zero pivot shows in the condition number
  Lapack<Scalar>::factorise(&n, &n, factors_.data(), &n, pivots_.data(), &info);
}

template <class Scalar>
Scalar LapackLu<Scalar>::reciprocal_condition() const {
  const int n = size();
  Column work(4 * n);
  VectorXi integer_work(n);
  Scalar result = 0;
  int info = 0;
  Lapack<Scalar>::condition("1", &n, factors_.data(), &n, &norm_, &result,
                            work.data(), integer_work.data(), &info);
  return info == 0 && std::isfinite(norm_) ? result : 0;
}

template <class Scalar>
typename LapackLu<Scalar>::Column LapackLu<Scalar>::solved(
    const char* transpose, Column right) const {
  assert(right.size() == factors_.rows());
  const int n = size(), one = 1;
  int info = 0;
  Lapack<Scalar>::solve(transpose, &n, &one, factors_.data(), &n,
                        pivots_.data(), right.data(), &n, &info);
  return right;
}

template <class Scalar>
typename LapackLu<Scalar>::Column LapackLu<Scalar>::solve(Column right) const {
  return solved("N", std::move(right));
}

template <class Scalar>
typename LapackLu<Scalar>::Column LapackLu<Scalar>::solve_transposed(
    Column right) const {
  return solved("T", std::move(right));
}

template class LapackLu<double>;
template class LapackLu<float>;

}  // namespace ffcontact
