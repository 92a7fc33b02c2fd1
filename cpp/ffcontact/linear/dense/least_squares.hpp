// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

// Eigen's decompositions are templates that take a compiler seconds in every file that
// calls them; those of dense matrices are compiled here (and in cholesky.cpp) once, or
// are LAPACK's.

/// Pivots below this part of the largest one count as zero.
struct PivotThreshold {
  double value = 0;  ///< 0: as many rounding errors as the matrix has pivots
};

/// The smallest of the x that make |A x - b| smallest, by LAPACK's complete orthogonal
/// decomposition; its rank is that of the largest leading triangle whose estimated
/// condition the threshold allows.
/// @param A  not empty
VectorXd least_squares(const MatrixXd& A, const VectorXd& b,
                       PivotThreshold threshold = {});

/// The same for every column of B.
MatrixXd least_squares_of_columns(const MatrixXd& A, const MatrixXd& B);

/// Basis of the x with A x = 0, one a column, by elimination with full pivoting; no
/// column where there is none but 0.
MatrixXd kernel_basis(const MatrixXd& A, PivotThreshold threshold = {});

/// Orthonormal basis of what the columns of A span.
/// @param A  of full rank, with as many rows as columns at least
MatrixXd orthonormal_basis(MatrixXd A);

}  // namespace ffcontact
