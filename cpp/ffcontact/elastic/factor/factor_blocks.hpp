// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/elastic/factor/subtrees.hpp"

namespace ffcontact {

/// The columns of a Cholesky factor L = [L_ii 0; L_ci I], supernode by supernode.
/// @tparam Scalar  double or float
template <class Scalar>
struct FactorBlocks {
  using Square = Matrix<Scalar, Dynamic, Dynamic>;
  using Column = Matrix<Scalar, Dynamic, 1>;

  Supernodes nodes;
  Subtrees tree;  ///< which threads share

  /// Values are not set: each page is first touched by the thread that fills it.
  explicit FactorBlocks(Supernodes of_nodes);

  /// That its work is worth.
  int thread_count() const;

  /// Of a supernode, by columns [rows x columns].
  Scalar* values_of(int s) const { return values_.get() + start_[s]; }
  Map<const Square> block(int s) const {
    return {values_of(s), nodes.row_count(s), nodes.column_count(s)};
  }

  /// (min L_jj / max L_jj)^2, 0 where a diagonal is not positive or not finite.
  double reciprocal_condition() const;

  /// L^-1 b; sums are in double precision, so that what stays of b_c has its own rounding.
  VectorXd half_solve(const VectorXd& right) const;
  VectorXd other_half_solve(const VectorXd& right) const;  ///< L'^-1 y

 private:
  /// x = L_ss^-1 b_s in place of b_s.
  /// @return L_rs x, r the rows below the diagonal block
  Column eliminate(int s, VectorXd& b) const;
  /// L_ss'^-1 (y_s - L_rs' y_r) in place of y_s.
  void substitute(int s, Column& y) const;

  bool worth_threads_;
  std::vector<std::size_t> start_;  ///< of the values of each supernode
  std::vector<int> above_;          ///< the columns above all subtrees
  std::vector<int> place_above_;    ///< of each column among these, or -1
  std::unique_ptr<Scalar[]> values_;
};

}  // namespace ffcontact
