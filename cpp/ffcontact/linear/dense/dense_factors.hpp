// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ffcontact {

/// Factors of dense matrices, by columns and in place, where A was. OpenMP's threads share
/// tiles of a fixed size and BLAS works on one: the digits do not depend on how many there
/// are. Scalar is double or float.

/// A = L L' on and below the diagonal [n x n].
/// @return is A positive definite?
template <class Scalar>
bool factorise_cholesky(int n, Scalar* A);

/// P A = L U [n x n], with the pivots [n] as LAPACK has them; singular where a U_jj is 0.
template <class Scalar>
void factorise_lu(int n, Scalar* A, int* pivots);

/// The first columns of L: L_11 L_11' = A_11 [columns x columns], L_21 = A_21 L_11'^-1.
/// @param rows  of both
/// @return is A_11 positive definite?
template <class Scalar>
bool factorise_columns(int rows, int columns, Scalar* A, int stride);

/// C = beta C - L L_1' on and below the diagonal.
/// @param columns  of C and rows of L_1, the first of L
template <class Scalar>
void subtract_lower_product(int rows, int columns, int depth, const Scalar* L,
                            int stride_l, Scalar beta, Scalar* C, int stride_c);

}  // namespace ffcontact
