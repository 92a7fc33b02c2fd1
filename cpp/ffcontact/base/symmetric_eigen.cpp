// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>

namespace ffcontact {

SymmetricEigen symmetric_eigen(const MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(A);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

}  // namespace ffcontact
