// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Eigenvalues, ascending, and orthonormal eigenvectors, one column each; compiled
/// once, as least_squares.
struct SymmetricEigen {
  VectorXd values;
  MatrixXd vectors;
};

/// @param A  symmetric, n x n, its lower triangle used
SymmetricEigen symmetric_eigen(const MatrixXd& A);

}  // namespace ffcontact
