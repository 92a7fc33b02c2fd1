// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/row_matrix.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace ffcontact {

namespace {

void sort_by_columns(RowMatrix& A) {
#pragma omp parallel
  {
    std::vector<std::pair<int, double>> sorted;
#pragma omp for
    for (Index i = 0; i < A.rows(); ++i) {
      const int first = A.outerIndexPtr()[i], end = A.outerIndexPtr()[i + 1];
      sorted.clear();
      for (int k = first; k < end; ++k)
        sorted.emplace_back(A.innerIndexPtr()[k], A.valuePtr()[k]);
      std::sort(sorted.begin(), sorted.end(),
                [](const auto& a, const auto& b) { return a.first < b.first; });
      for (int k = first; k < end; ++k)
        std::tie(A.innerIndexPtr()[k], A.valuePtr()[k]) = sorted[k - first];
    }
  }
}

}  // namespace

RowMatrix matrix_of_entries(Index rows, Index columns, Index entries,
                            const int* row, const int* column,
                            const double* value) {
  RowMatrix A(rows, columns);
  A.resizeNonZeros(entries);
  int* const first = A.outerIndexPtr();
  for (Index k = 0; k < entries; ++k) ++first[row[k] + 1];
  std::partial_sum(first, first + rows + 1, first);
  std::vector<int> next(first, first + rows);
  for (Index k = 0; k < entries; ++k) {
    const int place = next[row[k]]++;
    A.innerIndexPtr()[place] = column[k];
    A.valuePtr()[place] = value[k];
  }
  sort_by_columns(A);
  return A;
}

}  // namespace ffcontact
