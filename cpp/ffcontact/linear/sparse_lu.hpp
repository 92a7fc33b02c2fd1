// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// P A Q = L U of a sparse square matrix by SuiteSparse's KLU. That of the identity costs
/// nothing. One thread at a time may solve.
class SparseLu {
 public:
  /// @param A  square, not empty
  explicit SparseLu(SparseMatrix A);
  ~SparseLu();
  SparseLu(SparseLu&&) noexcept;

  bool is_regular() const;
  bool is_identity() const;

  VectorXd solve(const VectorXd& b) const;              ///< A^-1 b
  MatrixXd solve_columns(MatrixXd B) const;             ///< A^-1 B
  VectorXd solve_transposed(const VectorXd& b) const;   ///< A'^-1 b
  MatrixXd solve_transposed_columns(MatrixXd B) const;  ///< A'^-1 B

  /// A'^-1 S A^-1 of a symmetric S, exactly symmetric.
  MatrixXd congruent(MatrixXd S) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace ffcontact
