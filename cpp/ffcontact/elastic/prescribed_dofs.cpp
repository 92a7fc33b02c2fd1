// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/prescribed_dofs.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

constexpr double penalty_ratio = 1e12;

using RowIterator = RowMatrixView::InnerIterator;

struct RowSums {
  double diagonal = 0, others = 0;
};

RowSums row_sums(const RowMatrixView& A, Index row) {
  RowSums sums;
  for (RowIterator entry(A, row); entry; ++entry)
    (entry.col() == row ? sums.diagonal : sums.others) +=
        std::abs(entry.value());
  return sums;
}

/// Where the entries of A off its diagonal are.
struct OffDiagonal {
  Flags in_column;  ///< 1 where a column has any
  double largest = 0;

  void add(const RowIterator& entry) {
    if (entry.col() == entry.row() || entry.value() == 0) return;
    in_column[entry.col()] = 1;
    largest = std::max(largest, std::abs(entry.value()));
  }
};

OffDiagonal off_diagonal(const RowMatrixView& A) {
  OffDiagonal result{Flags(A.cols(), 0)};
  visit_entries(A, [&](const RowIterator& entry) { result.add(entry); });
  return result;
}

/// What stands on the diagonal of prescribed rows: FreeFEM prescribes with 1; in a matrix
/// that was scaled afterwards with another value, which then is that of them all.
/// @param diagonal  of the isolated dofs, `first` and others
double prescribing_value(const Eigen::ArrayXd& diagonal, Index first) {
  if ((diagonal == 1).any()) return 1;
  if ((diagonal == diagonal[0]).all()) return diagonal[0];
  refuse("dof ", first, " has nothing but its diagonal ", diagonal[0],
         " in A, others have another value, and none is 1: which of them are "
         "prescribed cannot be told; assemble A and b with tgv=-1 or the "
         "default tgv");
}

Eigen::ArrayXd diagonal_at(const RowMatrixView& A,
                           const std::vector<Index>& dofs) {
  return Eigen::ArrayXd::NullaryExpr(
      dofs.size(), [&](Index k) { return A.coeff(dofs[k], dofs[k]); });
}

/// Of the dofs that have nothing but a diagonal, neither in their row nor in their
/// column, marks those that are prescribed: with tgv=-2 a free dof whose neighbours are
/// all prescribed looks like them, but for its diagonal.
void mark_isolated(const RowMatrixView& A, const std::vector<Index>& isolated,
                   Flags& prescribed) {
  if (isolated.empty()) return;
  const Eigen::ArrayXd diagonal = diagonal_at(A, isolated);
  const double value = prescribing_value(diagonal, isolated.front());
  for (std::size_t k = 0; k < isolated.size(); ++k)
    prescribed[isolated[k]] = diagonal[k] == value;
}

}  // namespace

Flags prescribed_dofs(const RowMatrixView& A) {
  const OffDiagonal others = off_diagonal(A);
  Flags prescribed(A.rows(), 0);
  std::vector<Index> isolated;
  for (Index row = 0; row < A.rows(); ++row) {
    const RowSums sums = row_sums(A, row);
    if (sums.diagonal == 0) continue;
    const bool alone = sums.others == 0 && !others.in_column[row];
    const double scale = alone ? others.largest : sums.others;
    prescribed[row] =
        sums.diagonal > penalty_ratio * scale && !(alone && scale == 0);
    if (alone && !prescribed[row]) isolated.push_back(row);
  }
  mark_isolated(A, isolated, prescribed);
  return prescribed;
}

bool has_columns(const RowMatrixView& A, const Flags& prescribed) {
  const OffDiagonal others = off_diagonal(A);
  for (Index dof = 0; dof < A.cols(); ++dof)
    if (prescribed[dof] && others.in_column[dof]) return true;
  return false;
}

}  // namespace ffcontact
