// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/condensed/layer_springs.hpp"

#include "ffcontact/base/over.hpp"
#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// The rows that springs move, in their order.
std::vector<int> rows_on_layer(const VectorXd& compliance) {
  return numbers_where(static_cast<int>(compliance.size()),
                       [&](int row) { return compliance[row] > 0; });
}

/// With so many columns of 0 behind those that it has.
SparseMatrix widened(const SparseMatrix& A, Index columns) {
  SparseMatrix wide(A.rows(), A.cols() + columns);
  wide.leftCols(A.cols()) = A;
  return wide;
}

/// With a column behind it for each of some rows, 1 there.
SparseMatrix with_units_behind(const SparseMatrix& A,
                               const std::vector<int>& rows) {
  const int first = static_cast<int>(A.cols());
  Triplets ones;
  for (int k = 0; k < count_of(rows); ++k)
    ones.emplace_back(rows[k], first + k, 1);
  return widened(A, count_of(rows)) +
         packed(A.rows(), first + count_of(rows), ones);
}

/// With so many zeros behind it.
VectorXd lengthened(const VectorXd& values, Index zeros) {
  VectorXd longer = VectorXd::Zero(values.size() + zeros);
  longer.head(values.size()) = values;
  return longer;
}

}  // namespace

void add_layer(const VectorXd& compliance, ContactTrace& trace) {
  const std::vector<int> rows = rows_on_layer(compliance);
  if (rows.empty()) return;
  const int springs = count_of(rows);
  trace.A = with_units_behind(trace.A, rows);
  trace.to_kept = widened(trace.to_kept, springs);
  trace.layer_stiffness = compliance(rows).cwiseInverse();
  trace.opposite_load = lengthened(trace.opposite_load, springs);
}

}  // namespace ffcontact
