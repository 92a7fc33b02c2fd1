// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/block_pattern.hpp"

#include <algorithm>
#include <numeric>

namespace ffcontact {

namespace {

/// Row i of A B.
/// @param seen  of each column the last row that had it
void find_row(const BlockPattern& A, const BlockPattern& B, int i,
              std::vector<int>& seen, std::vector<int>& found) {
  found.clear();
  for (int k = A.begin(i); k < A.end(i); ++k) {
    const int j = A.column[k];
    for (int l = B.begin(j); l < B.end(j); ++l) {
      const int column = B.column[l];
      if (seen[column] == i) continue;
      seen[column] = i;
      found.push_back(column);
    }
  }
}

}  // namespace

BlockPattern product(const BlockPattern& A, const BlockPattern& B,
                     int columns) {
  const int rows = A.rows();
  BlockPattern result;
  result.first.assign(rows + 1, 0);
  // counted first, then written in place: the rows are found twice by all threads
  for (const bool counts : {true, false}) {
    if (!counts) {
      std::partial_sum(result.first.begin(), result.first.end(),
                       result.first.begin());
      result.column.resize(result.first.back());
    }
#pragma omp parallel
    {
      std::vector<int> seen(columns, -1), found;
#pragma omp for
      for (int i = 0; i < rows; ++i) {
        find_row(A, B, i, seen, found);
        if (counts) {
          result.first[i + 1] = static_cast<int>(found.size());
          continue;
        }
        std::sort(found.begin(), found.end());
        std::copy(found.begin(), found.end(),
                  result.column.begin() + result.first[i]);
      }
    }
  }
  return result;
}

TransposedPattern transposed(const BlockPattern& A, int columns) {
  TransposedPattern result;
  std::vector<int>& first = result.pattern.first;
  first.assign(columns + 1, 0);
  for (int column : A.column) ++first[column + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  result.pattern.column.resize(A.column.size());
  result.place.resize(A.column.size());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (int i = 0; i < A.rows(); ++i)
    for (int k = A.begin(i); k < A.end(i); ++k) {
      const int at = next[A.column[k]]++;
      result.pattern.column[at] = i;
      result.place[at] = k;
    }
  return result;
}

}  // namespace ffcontact
