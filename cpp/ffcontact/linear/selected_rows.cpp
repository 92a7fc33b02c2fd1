// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/selected_rows.hpp"

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

SparseMatrix selected_rows(const SparseMatrix& A,
                           const std::vector<int>& rows) {
  const auto count = count_of(rows);
  Triplets entries;
  for (int k = 0; k < count; ++k) entries.emplace_back(k, rows[k], 1.0);
  return packed(count, A.rows(), entries) * A;
}

}  // namespace ffcontact
