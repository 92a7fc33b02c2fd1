// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// A = U S V', by LAPACK.
struct SingularValues {
  VectorXd values;  ///< descending
  MatrixXd V;       ///< one column each
};

/// @param A  with as many rows as columns at least
SingularValues singular_values(MatrixXd A);

}  // namespace ffcontact
