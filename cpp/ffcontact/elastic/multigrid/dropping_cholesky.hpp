// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>

#include "ffcontact/linear/single.hpp"

namespace ffcontact {

/// A small dense symmetric positive semidefinite matrix that rounding has made regular: R A
/// R = P' L D L' P with R = diag(A)^-1/2 and the largest pivots first, of which those below
/// 1e-6 count as 0, what they divide as well.
class DroppingCholesky {
 public:
  DroppingCholesky() = default;
  explicit DroppingCholesky(const MatrixXd& A);

  /// An x with A x = b, if there is one.
  VectorXf solve(const VectorXf& b) const;

 private:
  VectorXd R_;
  Eigen::LDLT<MatrixXd> ldlt_;
};

}  // namespace ffcontact
