// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/singular_values.hpp"

#include <cassert>

#include "ffcontact/linear/dense/blas.hpp"
#include "ffcontact/linear/dense/serial_blas.hpp"

namespace ffcontact {

SingularValues singular_values(MatrixXd A) {
  assert(A.rows() >= A.cols() && A.cols() > 0);
  const int m = static_cast<int>(A.rows()), n = static_cast<int>(A.cols()),
            work_size = m + 64 * n, one = 1;
  VectorXd values(n), work(work_size);
  MatrixXd Vt(n, n);
  int info = 0;
  const SerialBlas serial;
  Blas<double>::gesvd("N", "A", &m, &n, A.data(), &m, values.data(), nullptr,
                      &one, Vt.data(), &n, work.data(), &work_size, &info);
  return {values, Vt.transpose()};
}

}  // namespace ffcontact
