// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/cholesky.hpp"

namespace ffcontact {

Cholesky::Cholesky(const Eigen::MatrixXd& H) : llt_(H) {}

double Cholesky::reciprocal_condition() const { return llt_.rcond(); }

Eigen::VectorXd Cholesky::solve(const Eigen::VectorXd& b) const { return llt_.solve(b); }

// Eigen's triangular solver refers to the first entry, also where there is none.
Eigen::MatrixXd Cholesky::solve_columns(const Eigen::MatrixXd& B) const {
  if (B.size() == 0) return B;
  return llt_.solve(B);
}

Eigen::MatrixXd Cholesky::half_solve(const Eigen::MatrixXd& B) const {
  if (B.size() == 0) return B;
  return llt_.matrixL().solve(B);
}

Eigen::VectorXd Cholesky::other_half_solve(Eigen::VectorXd z) const {
  llt_.matrixU().solveInPlace(z);
  return z;
}

}  // namespace ffcontact
