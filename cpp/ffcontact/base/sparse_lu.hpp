// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <memory>

namespace ffcontact {

/// P A Q = L U of a sparse square matrix by Eigen, compiled once, as least_squares.
class SparseLu {
 public:
  /// @param A  square, not empty
  explicit SparseLu(Eigen::SparseMatrix<double> A);
  ~SparseLu();
  SparseLu(SparseLu&&) noexcept;

  bool is_regular() const;

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;                     ///< A^-1 b
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& B) const;             ///< A^-1 B
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& b) const;          ///< A'^-1 b
  Eigen::MatrixXd solve_transposed_columns(const Eigen::MatrixXd& B) const;  ///< A'^-1 B

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace ffcontact
