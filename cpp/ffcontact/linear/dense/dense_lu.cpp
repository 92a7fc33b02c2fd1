// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/dense_lu.hpp"

#include <cassert>
#include <cmath>
#include <utility>

#include "ffcontact/linear/dense/blas.hpp"
#include "ffcontact/linear/dense/dense_factors.hpp"
#include "ffcontact/linear/dense/serial_blas.hpp"

namespace ffcontact {

template <class Scalar>
LapackLu<Scalar>::LapackLu(Square matrix)
    : factors_(std::move(matrix)),
      pivots_(factors_.rows()),
      norm_(factors_.cwiseAbs().colwise().sum().maxCoeff()) {
  assert(factors_.rows() == factors_.cols() && factors_.rows() > 0);
  // a zero pivot shows in the condition number
  factorise_lu(size(), factors_.data(), pivots_.data());
}

template <class Scalar>
Scalar LapackLu<Scalar>::reciprocal_condition() const {
  const int n = size();
  Column work(4 * n);
  VectorXi integer_work(n);
  Scalar result = 0;
  int info = 0;
  const SerialBlas serial;
  Blas<Scalar>::gecon("1", &n, factors_.data(), &n, &norm_, &result,
                      work.data(), integer_work.data(), &info);
  return info == 0 && std::isfinite(norm_) ? result : 0;
}

template <class Scalar>
int LapackLu<Scalar>::determinant_sign() const {
  int sign = 1;
  for (int k = 0; k < size(); ++k)
    if ((factors_(k, k) < 0) != (pivots_[k] != k + 1)) sign = -sign;
  return sign;
}

template <class Scalar>
typename LapackLu<Scalar>::Column LapackLu<Scalar>::solved(
    const char* transpose, Column right) const {
  assert(right.size() == factors_.rows());
  const int n = size(), one = 1;
  int info = 0;
  const SerialBlas serial;
  Blas<Scalar>::getrs(transpose, &n, &one, factors_.data(), &n, pivots_.data(),
                      right.data(), &n, &info);
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
