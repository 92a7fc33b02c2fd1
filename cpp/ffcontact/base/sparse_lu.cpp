// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/sparse_lu.hpp"

#include <Eigen/SparseLU>

namespace ffcontact {

struct SparseLu::Factor {
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;
};

SparseLu::SparseLu(Eigen::SparseMatrix<double> A) : factor_(std::make_unique<Factor>()) {
  A.makeCompressed();
  factor_->lu.compute(A);
}

SparseLu::~SparseLu() = default;

SparseLu::SparseLu(SparseLu&&) noexcept = default;

bool SparseLu::is_regular() const { return factor_->lu.info() == Eigen::Success; }

Eigen::VectorXd SparseLu::solve(const Eigen::VectorXd& b) const { return factor_->lu.solve(b); }

Eigen::VectorXd SparseLu::solve_transposed(const Eigen::VectorXd& b) const { return factor_->lu.transpose().solve(b); }

// Eigen's SparseLU does not take zero columns.
Eigen::MatrixXd SparseLu::solve_columns(const Eigen::MatrixXd& B) const {
  if (B.cols() == 0) return B;
  return factor_->lu.solve(B);
}

Eigen::MatrixXd SparseLu::solve_transposed_columns(const Eigen::MatrixXd& B) const {
  if (B.cols() == 0) return B;
  return factor_->lu.transpose().solve(B);
}

}  // namespace ffcontact
