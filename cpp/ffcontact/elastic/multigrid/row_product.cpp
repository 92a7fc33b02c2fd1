// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/row_product.hpp"

namespace ffcontact {

VectorXd row_product(const RowMatrix& A, const VectorXd& x) {
  VectorXd y(A.rows());
#pragma omp parallel for
  for (Index row = 0; row < A.rows(); ++row) {
    double sum = 0;
    for (RowMatrix::InnerIterator entry(A, row); entry; ++entry)
      sum += entry.value() * x[entry.col()];
    y[row] = sum;
  }
  return y;
}

}  // namespace ffcontact
