// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/products.hpp"

namespace ffcontact {

MatrixXd product(const Ref<const MatrixXd>& A, const Ref<const MatrixXd>& B) {
  return A * B;
}

MatrixXd transposed_product(const Ref<const MatrixXd>& A,
                            const Ref<const MatrixXd>& B) {
  return A.transpose() * B;
}

void add_square(const Ref<const MatrixXd>& A, MatrixXd& M) {
  M.noalias() += A * A.transpose();
}

}  // namespace ffcontact
