// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/matrix_free/product_equations.hpp"
#include "ffcontact/linear/dense/dense_cholesky.hpp"

namespace ffcontact {

/// Near the inverse of ProductEquations. With D of a state and T = I - D their lines are
///     T (H x - E q),  H = S + T^-1 c D,       B x + C q,
/// but for P_n's part of Coulomb's bound. H^-1 is taken for two levels, as in SchurSolver,
///     M = diag(H)^-1 + R (R' H R)^-1 R',
/// diag by vertices, R = 1 from an aggregate of vertices to the unknowns that they have in
/// these states, and q for that of its Schur complement with M. Each needs one product R'
/// S R: no more than a step of GMRES.
class ProductPreconditioner {
 public:
  /// @param equations  outlive it
  /// @param springs    on the unknowns, of diag(H)
  ProductPreconditioner(const ProductEquations& equations, double springs);

  VectorXd operator()(const VectorXd& scaled) const;

 private:
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  Index unknowns() const { return count_of(equations_.unknown); }
  void put_turned();
  void put_levels(double springs);
  MatrixXd put_conditions();
  void put_dependent();
  VectorXd approximate(const VectorXd& r) const;

  const ProductEquations& equations_;
  SparseMatrix T_inverse_;  ///< on the unknowns
  SparseMatrix added_;      ///< T^-1 c D
  SparseMatrix inverse_diagonal_, R_, E_, B_;
  DenseCholesky coarse_;
  MatrixXd dependent_inverse_;  ///< of C + B M E
};

}  // namespace ffcontact
