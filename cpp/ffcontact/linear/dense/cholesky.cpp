// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/cholesky.hpp"

namespace ffcontact {

Cholesky::Cholesky(const MatrixXd& H) : llt_(H) {}

double Cholesky::reciprocal_condition() const { return llt_.rcond(); }

// Eigen's triangular solver refers to the first entry, also where there is none.
VectorXd Cholesky::solve(const VectorXd& b) const {
  if (b.size() == 0) return b;
  return llt_.solve(b);
}

MatrixXd Cholesky::solve_columns(const MatrixXd& B) const {
  if (B.size() == 0) return B;
  return llt_.solve(B);
}

MatrixXd Cholesky::half_solve(const MatrixXd& B) const {
  if (B.size() == 0) return B;
  return llt_.matrixL().solve(B);
}

VectorXd Cholesky::other_half_solve(VectorXd z) const {
  llt_.matrixU().solveInPlace(z);
  return z;
}

}  // namespace ffcontact
