// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// sum_j |K_ij| of a row i.
inline double row_sum(const RowMatrix& K, Index row) {
  double sum = 0;
  for (RowMatrix::InnerIterator entry(K, row); entry; ++entry)
    sum += std::abs(entry.value());
  return sum;
}

}  // namespace ffcontact
