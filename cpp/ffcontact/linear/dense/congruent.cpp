// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/congruent.hpp"

#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/dense/symmetric.hpp"

namespace ffcontact {

MatrixXd congruent(const MatrixXd& S, const SparseMatrix& Q) {
  const SparseMatrix Qt = Q.transpose();
  MatrixXd result(Q.cols(), Q.cols());
#pragma omp parallel for schedule(dynamic, 64)
  for (Index j = 0; j < Q.cols(); ++j) {
    VectorXd column = VectorXd::Zero(S.rows());
    for (SparseMatrix::InnerIterator e(Q, j); e; ++e)
      column += e.value() * S.col(e.row());
    result.col(j) = Qt * column;
  }
  mirror_lower(result);
  return result;
}

MatrixXd congruent(const MatrixXd& S, const MatrixXd& Q) {
  return product(transposed_product(Q, S), Q);
}

}  // namespace ffcontact
