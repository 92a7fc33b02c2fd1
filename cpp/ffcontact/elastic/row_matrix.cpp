// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/row_matrix.hpp"

#include <omp.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace ffcontact {

namespace {

/// Calls visit(k) for all entries, for those of a row in their order, on one thread.
template <class Visit>
void visit_unsorted(Index rows, Index entries, const int* row,
                    const Visit& visit) {
  const int parts = omp_get_max_threads();
#pragma omp parallel for
  for (int part = 0; part < parts; ++part) {
    const Index begin = rows * part / parts, end = rows * (part + 1) / parts;
    for (Index k = 0; k < entries; ++k)
      if (begin <= row[k] && row[k] < end) visit(k);
  }
}

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
  visit_unsorted(rows, entries, row, [&](Index k) { ++first[row[k] + 1]; });
  std::partial_sum(first, first + rows + 1, first);
  std::vector<int> next(first, first + rows);
  visit_unsorted(rows, entries, row, [&](Index k) {
    const int place = next[row[k]]++;
    A.innerIndexPtr()[place] = column[k];
    A.valuePtr()[place] = value[k];
  });
  sort_by_columns(A);
  return A;
}

}  // namespace ffcontact
