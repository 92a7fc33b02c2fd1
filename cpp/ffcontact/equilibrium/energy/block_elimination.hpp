// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// A = L L' of a symmetric positive semidefinite matrix whose blocks are coupled with the
/// next ones alone, block by block. A pivot below 1e-11 of its diagonal entry before the
/// elimination is that of a dependent unknown: it becomes infinite, and what is below it 0.
class BlockElimination {
 public:
  explicit BlockElimination(const MatrixXd& first)
      : A_(first), diagonal_(first.diagonal()) {}

  /// The block after the present one, and what couples it with that [next x present].
  void append(const MatrixXd& next, const MatrixXd& coupling);
  /// The columns of L of the present block, its lower triangle (what is above it means
  /// nothing) and the rows of the next one, which takes its place.
  MatrixXd eliminated();

 private:
  Index present() const { return diagonal_.size() - next_; }
  bool is_dependent(Index column) const;
  void eliminate(Index column);

  MatrixXd A_;  ///< of the present block and the next one, the lower triangle
  VectorXd diagonal_;  ///< of these, before others took their part
  Index next_ = 0;     ///< rows of the next block
};

}  // namespace ffcontact
