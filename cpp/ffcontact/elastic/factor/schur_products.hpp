// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Where Schur's complement S of CondensedStiffness is.
enum class SchurStorage {
  whole,        ///< one dense matrix on this machine, for dense algebra
  distributed,  ///< by blocks on the processes that factorise, for products
};

/// @throws std::invalid_argument  if S is distributed: dense algebra is asked for
void require_whole(SchurStorage storage);

/// Schur's complement S of a stiffness by what it does, wherever its entries are.
class SchurProducts {
 public:
  virtual ~SchurProducts() = default;

  virtual Index size() const = 0;
  /// S x, the same digits on any number of threads [kept].
  virtual VectorXd product(const VectorXd& x) const = 0;
  /// R' S R of a sparse R [kept x columns].
  virtual MatrixXd congruent(const SparseMatrix& R) const = 0;
  /// S_ij where i and j are of one group, 0 elsewhere [kept x kept].
  /// @param group  of each kept dof, of few each
  virtual SparseMatrix diagonal_blocks(const std::vector<int>& group) const = 0;

  VectorXd diagonal() const;
};

/// Of a matrix at hand.
class WholeSchur : public SchurProducts {
 public:
  /// @param S  stays with the caller
  explicit WholeSchur(const MatrixXd& S) : S_(S) {}

  Index size() const override { return S_.rows(); }
  VectorXd product(const VectorXd& x) const override;
  MatrixXd congruent(const SparseMatrix& R) const override;
  SparseMatrix diagonal_blocks(const std::vector<int>& group) const override;

 private:
  const MatrixXd& S_;
};

}  // namespace ffcontact
