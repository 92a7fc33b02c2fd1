// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/dense_cholesky.hpp"

#include <cassert>
#include <utility>

#include "ffcontact/base/blas.hpp"

namespace ffcontact {

DenseCholesky::DenseCholesky(MatrixXd H) : factor_(std::move(H)) {
  assert(factor_.rows() == factor_.cols());
  const int n = static_cast<int>(factor_.rows());
  int info = 0;
  // LAPACK asks for a stride of 1 at least
  if (n > 0) Blas<double>::potrf("L", &n, factor_.data(), &n, &info);
  is_positive_definite_ = info == 0;
}

VectorXd DenseCholesky::solve(VectorXd right) const {
  assert(right.size() == factor_.rows());
  const int n = static_cast<int>(factor_.rows()), one = 1;
  int info = 0;
  if (n > 0)
    Blas<double>::potrs("L", &n, &one, factor_.data(), &n, right.data(), &n,
                        &info);
  return right;
}

}  // namespace ffcontact
