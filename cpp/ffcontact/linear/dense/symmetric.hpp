// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Makes a matrix symmetric by its lower triangle, block by block: some thousand columns
/// do not fit into the cache.
template <class Scalar>
void mirror_lower(Matrix<Scalar, Dynamic, Dynamic>& M) {
  constexpr Index block = 64;
  const Index n = M.rows();
  for (Index j = 0; j < n; j += block) {
    const Index columns = std::min(block, n - j);
    for (Index k = j; k < j + columns; ++k)
      M.row(k).segment(k, j + columns - k) =
          M.col(k).segment(k, j + columns - k).transpose();
    for (Index i = j + columns; i < n; i += block) {
      const Index rows = std::min(block, n - i);
      M.block(j, i, columns, rows) = M.block(i, j, rows, columns).transpose();
    }
  }
}

}  // namespace ffcontact
