// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/sparse_lu.hpp"

#include <Eigen/SparseLU>

namespace ffcontact {

namespace {

bool equals_identity(const SparseMatrix& A) {
  if (A.nonZeros() != A.cols()) return false;
  for (int j = 0; j < A.cols(); ++j)
    if (A.coeff(j, j) != 1) return false;
  return true;
}

}  // namespace

struct SparseLu::Factor {
  bool identity;
  Eigen::SparseLU<SparseMatrix> lu;
};

SparseLu::SparseLu(SparseMatrix A) : factor_(std::make_unique<Factor>()) {
  A.makeCompressed();
  factor_->identity = equals_identity(A);
  if (!factor_->identity) factor_->lu.compute(A);
}

SparseLu::~SparseLu() = default;

SparseLu::SparseLu(SparseLu&&) noexcept = default;

bool SparseLu::is_regular() const {
  return factor_->identity || factor_->lu.info() == Eigen::Success;
}

bool SparseLu::is_identity() const { return factor_->identity; }

VectorXd SparseLu::solve(const VectorXd& b) const {
  return factor_->identity ? b : VectorXd(factor_->lu.solve(b));
}

VectorXd SparseLu::solve_transposed(const VectorXd& b) const {
  return factor_->identity ? b : VectorXd(factor_->lu.transpose().solve(b));
}

// Eigen's SparseLU does not take zero columns.
MatrixXd SparseLu::solve_columns(const MatrixXd& B) const {
  if (B.cols() == 0 || factor_->identity) return B;
  return factor_->lu.solve(B);
}

MatrixXd SparseLu::solve_transposed_columns(const MatrixXd& B) const {
  if (B.cols() == 0 || factor_->identity) return B;
  return factor_->lu.transpose().solve(B);
}

}  // namespace ffcontact
