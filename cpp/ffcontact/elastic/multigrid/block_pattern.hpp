// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace ffcontact {

/// Where the blocks of a sparse matrix are: row i has the columns column[first[i]], ...,
/// column[first[i + 1] - 1], ascending.
struct BlockPattern {
  std::vector<int> first{0}, column;

  int rows() const { return static_cast<int>(first.size()) - 1; }
  int begin(int row) const { return first[row]; }
  int end(int row) const { return first[row + 1]; }
};

/// Of A B, in the sense of the graphs.
/// @param columns  of B
BlockPattern product(const BlockPattern& A, const BlockPattern& B, int columns);

/// Of A', and where in A each of its blocks is.
struct TransposedPattern {
  BlockPattern pattern;
  std::vector<int> place;
};
TransposedPattern transposed(const BlockPattern& A, int columns);

}  // namespace ffcontact
