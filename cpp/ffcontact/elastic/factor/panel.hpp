// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Columns first .. end of a dense block of the factor, or of S, by columns.
template <class Scalar>
struct Panel {
  int first, end;
  Scalar* values;  ///< of column `first`, from the block's first row on
  int stride;
  const int* place;  ///< of each row in the block
};

/// The last rows of a supernode of the factor, by columns.
template <class Scalar>
struct FactorRows {
  const Scalar* values;
  int stride, depth;  ///< rows and columns of the supernode
  const int* row;     ///< their numbers, ascending
  int rows;           ///< how many
  int columns;        ///< the first of them, which are columns of a panel
};

/// panel -= L L_c' on the rows of L, with L_c its first rows `columns`; above the diagonal
/// it leaves what nothing reads.
/// @param product  workspace of at least rows x columns, for rows that are scattered
/// @tparam Scalar  double or float
template <class Scalar>
void subtract_product(const FactorRows<Scalar>& L, const Panel<Scalar>& panel,
                      Matrix<Scalar, Dynamic, 1>& product);

}  // namespace ffcontact
