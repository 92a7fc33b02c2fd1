// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// H = L L' of a dense symmetric matrix, of which the lower triangle is read; compiled
/// once, as least_squares.
class Cholesky {
 public:
  Cholesky() = default;
  explicit Cholesky(const MatrixXd& H);

  bool is_positive_definite() const { return llt_.info() == Eigen::Success; }
  double reciprocal_condition()
      const;  ///< estimate of 1 / (|H| |H^-1|) in the 1-norm

  const MatrixXd& lower() const {  ///< L in its lower triangle
    return llt_.matrixLLT();
  }
  VectorXd solve(const VectorXd& b) const;          ///< H^-1 b
  MatrixXd solve_columns(const MatrixXd& B) const;  ///< H^-1 B
  MatrixXd half_solve(const MatrixXd& B) const;     ///< L^-1 B
  VectorXd other_half_solve(VectorXd z) const;      ///< L'^-1 z

 private:
  Eigen::LLT<MatrixXd> llt_;
};

}  // namespace ffcontact
