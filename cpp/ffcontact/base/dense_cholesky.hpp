// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// H = L L' of a large dense symmetric matrix by LAPACK, as DenseLu; for some dozen
/// unknowns Cholesky is faster.
class DenseCholesky {
 public:
  DenseCholesky() = default;
  /// @param H  square; its lower triangle is read
  explicit DenseCholesky(MatrixXd H);

  bool is_positive_definite() const { return is_positive_definite_; }

  /// H^-1 b, for a matrix that is positive definite.
  VectorXd solve(VectorXd right) const;

 private:
  MatrixXd factor_;
  bool is_positive_definite_ = false;
};

}  // namespace ffcontact
