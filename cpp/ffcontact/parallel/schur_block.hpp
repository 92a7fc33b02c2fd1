// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/single.hpp"

namespace ffcontact {

/// The rows and columns of a matrix S that one process has: every entry S_ij is in the
/// block of one process, and what they give for theirs add up to that of S.
struct SchurBlock {
  std::vector<int> row, column;             ///< of S, ascending
  std::variant<MatrixXd, MatrixXf> values;  ///< [rows x columns]
};

/// Which of `size` numbers are at one of `count` places that numbers are dealt to in
/// runs of `length`, one place after the other (ScaLAPACK's block-cyclic distribution).
std::vector<int> dealt_numbers(int size, int length, int place, int count);

/// Of S x on the block's rows, summed in double precision; the same digits on any number
/// of threads.
/// @param x  on all of S
VectorXd product_part(const SchurBlock& block, const VectorXd& x);

/// Of R' S R.
MatrixXd congruent_part(const SchurBlock& block, const SparseMatrix& R);

/// S_ij where i and j are of one group.
/// @param group  of each row of S
Triplets diagonal_part(const SchurBlock& block, const std::vector<int>& group);

}  // namespace ffcontact
