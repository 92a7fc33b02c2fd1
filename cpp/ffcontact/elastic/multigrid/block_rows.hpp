// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/multigrid/block_pattern.hpp"
#include "ffcontact/linear/single.hpp"

namespace ffcontact {

template <int rows, int columns>
using SingleBlock = Matrix<float, rows, columns>;

/// Block i of a vector.
template <int size, class Vector>
auto block_of(Vector& x, int i) {
  return x.template segment<size>(static_cast<Index>(size) * i);
}

/// A sparse matrix of dense blocks in single precision. What is done row by row has the
/// same digits on any number of threads.
template <int height, int width>
struct BlockRows {
  using Block = SingleBlock<height, width>;
  BlockPattern pattern;
  std::vector<Block> value;  ///< in the order of the pattern's columns

  int rows() const { return pattern.rows(); }

  /// Row i of A x.
  SingleBlock<height, 1> row_times(int i, const VectorXf& x) const {
    SingleBlock<height, 1> sum = SingleBlock<height, 1>::Zero();
    for (int k = pattern.begin(i); k < pattern.end(i); ++k)
      sum += value[k] * block_of<width>(x, pattern.column[k]);
    return sum;
  }

  /// A block, which has a place.
  Block& block(int i, int j) { return value[place(i, j)]; }
  const Block& block(int i, int j) const { return value[place(i, j)]; }

 private:
  int place(int i, int j) const {
    int k = pattern.begin(i);
    while (pattern.column[k] != j) ++k;
    return k;
  }
};

/// A x
template <int height, int width>
VectorXf product(const BlockRows<height, width>& A, const VectorXf& x);

}  // namespace ffcontact
