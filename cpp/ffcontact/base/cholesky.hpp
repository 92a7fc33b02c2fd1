// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>

namespace ffcontact {

/// H = L L' of a dense symmetric matrix, of which the lower triangle is read; compiled once, as least_squares.
class Cholesky {
 public:
  Cholesky() = default;
  explicit Cholesky(const Eigen::MatrixXd& H);

  bool is_positive_definite() const { return llt_.info() == Eigen::Success; }
  double reciprocal_condition() const;  ///< estimate of 1 / (|H| |H^-1|) in the 1-norm

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;          ///< H^-1 b
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& B) const;  ///< H^-1 B
  Eigen::MatrixXd half_solve(const Eigen::MatrixXd& B) const;     ///< L^-1 B
  Eigen::VectorXd other_half_solve(Eigen::VectorXd z) const;      ///< L'^-1 z

 private:
  Eigen::LLT<Eigen::MatrixXd> llt_;
};

}  // namespace ffcontact
