// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Rows are read (a prescribed row tells itself), so matrices are stored by rows.
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using RowMatrixView = Ref<const RowMatrix>;

/// A matrix that is moved where it can be: Eigen 3.4 copies it.
class MovableMatrix : public RowMatrix {
 public:
  using RowMatrix::operator=;

  MovableMatrix() = default;
  MovableMatrix(const RowMatrix& matrix) : RowMatrix(matrix) {}
  MovableMatrix(RowMatrix&& matrix) { swap(matrix); }

  MovableMatrix(const MovableMatrix&) = default;
  MovableMatrix(MovableMatrix&& matrix) noexcept { swap(matrix); }
  MovableMatrix& operator=(const MovableMatrix&) = default;
  MovableMatrix& operator=(MovableMatrix&& matrix) noexcept {
    swap(matrix);
    return *this;
  }
  ~MovableMatrix() = default;
};

/// From entries in any order, of which no two are in one place, in the room of the matrix
/// alone (packed takes that of two, and triplets).
/// @param row, column, value  of each of so many entries
RowMatrix matrix_of_entries(Index rows, Index columns, Index entries,
                            const int* row, const int* column,
                            const double* value);

/// Calls visit(entry) for every entry that is stored, row by row.
template <class Visit>
void visit_entries(const RowMatrixView& A, Visit&& visit) {
  for (Index row = 0; row < A.rows(); ++row)
    for (RowMatrixView::InnerIterator entry(A, row); entry; ++entry)
      visit(entry);
}

}  // namespace ffcontact
