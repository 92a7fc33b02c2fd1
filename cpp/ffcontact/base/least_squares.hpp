// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

// Eigen's decompositions are templates that take a compiler seconds in every file that
// calls them; those of dense matrices are compiled here (and in cholesky.cpp) once.

/// Pivots below this part of the largest one count as zero.
struct PivotThreshold {
  double value = 0;  ///< 0: as many rounding errors as the matrix has columns
};

/// The smallest of the x that make |A x - b| smallest, by a complete orthogonal
/// decomposition.
/// @param A  not empty
VectorXd least_squares(const MatrixXd& A, const VectorXd& b,
                       PivotThreshold threshold = {});

/// The same for every column of B.
MatrixXd least_squares_of_columns(const MatrixXd& A, const MatrixXd& B);

/// Basis of the x with A x = 0, one a column, by elimination with full pivoting; no
/// column where there is none but 0.
MatrixXd kernel_basis(const MatrixXd& A, PivotThreshold threshold = {});

}  // namespace ffcontact
