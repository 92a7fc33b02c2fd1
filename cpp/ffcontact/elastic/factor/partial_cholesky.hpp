// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/base/progress.hpp"
#include "ffcontact/elastic/factor/supernodes.hpp"

namespace ffcontact {

/// A sparse symmetric matrix whose last rows and columns c stay while all others i are
/// eliminated, in its own order:
///     A = L [I 0; 0 S] L',   L = [L_ii 0; L_ci I],   S = A_cc - A_ci A_ii^-1 A_ic,
/// so that Schur's complement S is neither factored nor made anew of its factor.
///
/// Supernodal and left-looking, as CHOLMOD's, in dense blocks by BLAS. Every entry is
/// computed in the same order whatever the number of threads. The threads of OpenMP share
/// the subtrees of the elimination tree; above them, and in S, the columns.
/// @tparam Scalar  double, or float: half the time and the memory, for what is refined
template <class Scalar>
class PartialCholesky {
 public:
  using Square = Matrix<Scalar, Dynamic, Dynamic>;

  /// @param lower  the lower triangle of A, rows of a column in any order
  /// @param kept   size of S
  /// @param report  told of the columns of L_ii and of S as the calling thread goes on
  PartialCholesky(const SparseMatrix& lower, int kept,
                  const ProgressReport& report = {});
  ~PartialCholesky();
  PartialCholesky(PartialCholesky&&) noexcept;
  PartialCholesky& operator=(PartialCholesky&&) noexcept;

  /// (min L_jj / max L_jj)^2 of L_ii, 0 where A_ii is not positive definite.
  double reciprocal_condition() const;
  /// S, which is handed over [kept x kept].
  Square take_schur();

  /// L^-1 b; sums are in double precision, so that what stays of b_c has its own rounding
  VectorXd half_solve(const VectorXd& right) const;
  VectorXd other_half_solve(const VectorXd& right) const;  ///< L'^-1 y

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace ffcontact
