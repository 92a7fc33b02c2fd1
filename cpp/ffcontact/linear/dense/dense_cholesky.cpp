// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/dense_cholesky.hpp"

#include <cassert>
#include <utility>

#include "ffcontact/linear/dense/blas.hpp"
#include "ffcontact/linear/dense/dense_factors.hpp"
#include "ffcontact/linear/dense/serial_blas.hpp"

namespace ffcontact {

template <class Scalar>
LapackCholesky<Scalar>::LapackCholesky(Square H) : factor_(std::move(H)) {
  assert(factor_.rows() == factor_.cols());
  is_positive_definite_ = factorise_cholesky(size(), factor_.data());
}

template <class Scalar>
typename LapackCholesky<Scalar>::Column LapackCholesky<Scalar>::solve(
    Column right) const {
  assert(right.size() == factor_.rows());
  const int n = size(), one = 1;
  int info = 0;
  const SerialBlas serial;
  // LAPACK asks for a stride of 1 at least
  if (n > 0)
    Blas<Scalar>::potrs("L", &n, &one, factor_.data(), &n, right.data(), &n,
                        &info);
  return right;
}

template class LapackCholesky<double>;
template class LapackCholesky<float>;

}  // namespace ffcontact
