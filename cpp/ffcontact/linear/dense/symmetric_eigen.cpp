// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/symmetric_eigen.hpp"

#include <utility>

#include "ffcontact/linear/dense/blas.hpp"
#include "ffcontact/linear/dense/serial_blas.hpp"

namespace ffcontact {

SymmetricEigen symmetric_eigen(MatrixXd A) {
  const int n = static_cast<int>(A.rows()), work_size = 34 * n;
  SymmetricEigen eigen{VectorXd(n), std::move(A)};
  if (n == 0) return eigen;
  VectorXd work(work_size);
  int info = 0;
  const SerialBlas serial;
  Blas<double>::syev("V", "L", &n, eigen.vectors.data(), &n,
                     eigen.values.data(), work.data(), &work_size, &info);
  return eigen;
}

}  // namespace ffcontact
