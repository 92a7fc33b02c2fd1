// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/row_matrix.hpp"

namespace ffcontact {

/// A x, row by row on all threads.
VectorXd row_product(const RowMatrix& A, const VectorXd& x);

}  // namespace ffcontact
