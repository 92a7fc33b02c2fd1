// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "ffcontact/linear/dense/dense_cholesky.hpp"

namespace ffcontact {

/// u_c of (S + s Z Z') u_c = g, with the Schur complement S of CondensedStiffness: regular
/// where contact alone holds the rigid motions Z. s is the mean of diag(S) over that of
/// |Z_k|^2, so that what they add is of the size of S.
///
/// By Cholesky's factor; of a stiffness that is not exact, whose answers are corrected
/// anyhow, by conjugate gradients to 1e-5, with a preconditioner of two levels,
///     diag(S)^-1 + R (R' S R)^-1 R',
/// R = 1 from an aggregate of neighbouring vertices to these, one column a component. S is
/// of order 1, as it takes displacements to tractions: such an R needs no smoothing, and
/// steps do not grow with the number of dofs (26 to 30 for 243 to 3267 kept ones, held or
/// not, where the diagonal alone takes 43 to 178). That is n^2 in place of n^3 / 3
/// operations. Where they are not enough, as for nu of 0.499, Cholesky's factor is made.
class SchurSolver {
 public:
  /// @param kept       of the stiffness
  /// @param stiffness  stays with the caller
  /// @param motions    Z on the kept dofs [kept x k]
  SchurSolver(const ElasticSystem& system, const std::vector<int>& kept,
              const CondensedStiffness& stiffness, const MatrixXd& motions,
              int most_steps = 100);
  ~SchurSolver();

  /// @return the same digits for every number of threads where it is not factored
  VectorXd solve(const VectorXd& g) const;

 private:
  struct TwoLevels;

  MatrixXd regular_matrix() const;

  const MatrixXd& S_;
  int most_steps_;
  MatrixXd motions_;  ///< s^(1/2) Z
  std::unique_ptr<const TwoLevels> preconditioner_;
  mutable DenseCholesky direct_;  ///< made where it is needed
};

}  // namespace ffcontact
