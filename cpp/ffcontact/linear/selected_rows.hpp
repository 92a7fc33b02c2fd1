// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Some rows of a sparse matrix, in the order in which they are listed [rows x columns].
SparseMatrix selected_rows(const SparseMatrix& A, const std::vector<int>& rows);

}  // namespace ffcontact
