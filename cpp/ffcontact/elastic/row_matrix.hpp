// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Rows are read (a prescribed row tells itself), so matrices are stored by rows.
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using RowMatrixView = Ref<const RowMatrix>;

/// Calls visit(entry) for every entry that is stored, row by row.
template <class Visit>
void visit_entries(const RowMatrixView& A, Visit&& visit) {
  for (Index row = 0; row < A.rows(); ++row)
    for (RowMatrixView::InnerIterator entry(A, row); entry; ++entry)
      visit(entry);
}

}  // namespace ffcontact
