// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Eigenvalues, ascending, and orthonormal eigenvectors, one column each, by LAPACK.
struct SymmetricEigen {
  VectorXd values;
  MatrixXd vectors;
};

/// @param A  symmetric, n x n, its lower triangle used
SymmetricEigen symmetric_eigen(MatrixXd A);

}  // namespace ffcontact
